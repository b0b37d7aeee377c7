"""What Zavodszky et al. 2020 (doi 10.1002/cnm.3340) state, and the closed forms behind it."""

from math import sqrt

MMHG = 133.322387415  # Pa

# Table 1: nominal diameter [mm] -> dL/dR = t.
BRAID_RATIO = {2.5: 0.54, 3.0: 0.48, 3.5: 0.44, 4.0: 0.40, 4.5: 0.37, 5.0: 0.35}

# Section 3: "a push of 66% dL reduction".
PUSH = 1.0 - 0.66

# Table 3: case -> nominal diameter [mm], push, and the four figures.
SCENARIOS = {
    "4mm": {"diameter": 4.0, "push": False},
    "4mm_push": {"diameter": 4.0, "push": True},
    "5mm": {"diameter": 5.0, "push": False},
    "5mm_push": {"diameter": 5.0, "push": True},
}
TABLE_3 = {
    "density_increase": {"4mm": 66, "4mm_push": 128, "5mm": 59, "5mm_push": 118},       # %
    "implanted_length": {"4mm": 21, "4mm_push": 15, "5mm": 22, "5mm_push": 17},         # mm
    "expansion": {"4mm": 2.00, "4mm_push": 2.13, "5mm": 2.50, "5mm_push": 2.64},        # mm
    "contact_pressure": {"4mm": 36.9, "4mm_push": 42.6, "5mm": 86.1, "5mm_push": 83.3},  # mmHg
}


def length_ratio(braid_ratio, radius_ratio):
    """L / L0 of a force-free braid at R / R0: sqrt(t^2 + 1 - (R/R0)^2) / t (Figure 2)."""
    return sqrt(braid_ratio**2 + 1.0 - radius_ratio**2) / braid_ratio


def radius_ratio(braid_ratio, spacing_ratio):
    """R / R0 of a force-free braid at lambda times its nominal spacing."""
    return sqrt(1.0 + braid_ratio**2 * (1.0 - spacing_ratio**2))


def fitted_braid_ratio(length_ratios, radius_ratios):
    """t of the braid whose force-free lengths come closest to the given ones.

    (L/L0)^2 = 1 + (1 - (R/R0)^2) / t^2 is linear in 1 / t^2, which least squares then gives.
    """
    x = [1.0 - r**2 for r in radius_ratios]
    y = [q**2 - 1.0 for q in length_ratios]
    return sqrt(sum(a * a for a in x) / sum(a * b for a, b in zip(x, y)))

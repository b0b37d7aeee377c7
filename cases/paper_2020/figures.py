"""The figures of Zavodszky et al. 2020, drawn with matplotlib from Braidzone's results."""

import matplotlib

matplotlib.use("Agg")

import xml.etree.ElementTree as ElementTree

import matplotlib.pyplot as plt
import numpy
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import ListedColormap, Normalize

from paper import BRAID_RATIO, MMHG, SCENARIOS, TABLE_3, length_ratio
from runs import Surface, read_stl

plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False})

COLOURS = plt.get_cmap("viridis")
TITLES = {"4mm": "4 mm", "4mm_push": "4 mm, push", "5mm": "5 mm", "5mm_push": "5 mm, push"}


def save(figure, file):
    figure.savefig(file, dpi=160, bbox_inches="tight")
    plt.close(figure)


def figure_2(file, points):
    """Resting length against artery diameter."""
    figure, axes = plt.subplots(figsize=(6.2, 4.2))
    for i, (nominal, ratio) in enumerate(BRAID_RATIO.items()):
        colour = COLOURS(i / 5.5)
        arteries = numpy.linspace(nominal - 1.25, nominal, 100)
        axes.plot(arteries, [20.0 * length_ratio(ratio, a / nominal) for a in arteries],
                  color=colour, lw=1.2)
        mine = [p for p in points if p["nominal"] == nominal]
        axes.plot([p["artery"] for p in mine], [p["simulated"] for p in mine], "o", color=colour,
                  ms=5, label=f"{nominal:g} mm")
    axes.plot([], [], color="grey", lw=1.2, label="closed form")
    axes.set(xlabel="artery diameter (mm)", ylabel="resting length of a 20 mm device (mm)",
             ylim=(18, None))
    axes.legend(title="simulated, nominal", frameon=False, loc="upper left",
                bbox_to_anchor=(1.01, 1.0))
    axes.grid(alpha=0.25)
    save(figure, file)


def figure_4(file, curves):
    """Force of the presser head against its displacement."""
    figure, axes = plt.subplots(figsize=(5.6, 3.8))
    for (nominal, forces), points in curves.items():
        axes.plot(*zip(*points), "o-" if forces == "wire-theory" else "s--", ms=4,
                  color=COLOURS(0.2 if nominal == 4 else 0.7), label=f"{nominal} mm, {forces}")
    axes.set(xlabel="displacement of the head (mm)", ylabel="force (mN)", xlim=(0, None),
             ylim=(0, None))
    axes.legend(frameon=False)
    axes.grid(alpha=0.25)
    save(figure, file)


def table_3(file, results):
    """The four figures of Table 3 for the four scenarios: the paper's and each lattice's."""
    panels = [("implanted_length", "implanted length (mm)"),
              ("expansion", "radial expansion at the neck (mm)"),
              ("density_increase", "density increase, free side of the neck (%)"),
              ("contact_pressure", "contact pressure F/A0 (mmHg)")]
    figure, axes = plt.subplots(2, 2, figsize=(8.2, 5.6), constrained_layout=True)
    at = numpy.arange(len(SCENARIOS))
    width = 0.8 / len(results)
    for (key, title), box in zip(panels, axes.flat):
        for i, (lattice, values) in enumerate(results.items()):
            box.bar(at + (i - 0.5 * (len(results) - 1)) * width, [values[n][key] for n in SCENARIOS],
                    0.92 * width, color=COLOURS(0.2 + 0.3 * i), label=lattice)
        box.plot(at, [TABLE_3[key][n] for n in SCENARIOS], "D", color="crimson", ms=6,
                 mec="white", label="paper", zorder=3)
        box.axhline(0, color="black", lw=0.6)
        box.set_xticks(at, [TITLES[n] for n in SCENARIOS])
        box.set_ylabel(title)
    axes[0, 1].set_ylim(1.5, 2.8)
    figure.legend(*axes[0, 0].get_legend_handles_labels(), loc="lower center",
                  ncol=len(results) + 1, frameon=False, bbox_to_anchor=(0.5, -0.06))
    save(figure, file)


# ---- devices in vessels, seen from the side --------------------------------------------------

class View:
    """Orthographic view along the direction in which the vessel is thinnest."""

    def __init__(self, triangles):
        points = triangles.reshape(-1, 3)
        self.centre = points.mean(axis=0)
        _, axes = numpy.linalg.eigh(numpy.cov((points - self.centre).T))
        right, up = axes[:, 2], axes[:, 1]
        # The largest coordinate positive: the same picture whatever the sign of the eigenvectors.
        right, up = (v * numpy.sign(v[numpy.abs(v).argmax()]) for v in (right, up))
        self.axes = numpy.stack([right, up, numpy.cross(right, up)])

    def project(self, points):
        """Right, up and towards the viewer, of points of any shape (..., 3)."""
        return (points - self.centre) @ self.axes.T


def draw_far_wall(axes, view, triangles):
    """The half of the wall behind the device, shaded."""
    seen = view.project(triangles)
    normals = numpy.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    far = normals[:, 2] < 0
    shade = 0.72 + 0.24 * numpy.abs(normals[far, 2])
    axes.add_collection(PolyCollection(seen[far][:, :, :2], closed=True, lw=0.2,
                                       facecolors=numpy.repeat(shade[:, None], 3, axis=1),
                                       edgecolors="face"))
    low, high = seen[..., :2].min(axis=(0, 1)), seen[..., :2].max(axis=(0, 1))
    axes.set(xlim=(low[0] - 0.5, high[0] + 0.5), ylim=(low[1] - 0.5, high[1] + 0.5), aspect="equal")
    axes.axis("off")


def draw_cells(axes, view, surface, values, norm):
    """The braid's pores coloured by a value, far ones first."""
    seen = view.project(surface.points[surface.polygons])
    order = seen[:, :, 2].mean(axis=1).argsort()
    axes.add_collection(PolyCollection(seen[order][:, :, :2], array=values[order], norm=norm,
                                       cmap=COLOURS, lw=0.1, edgecolors="face"))


def draw_wires(axes, view, surface):
    """The sides of the pores, far ones paler and first."""
    corners = surface.polygons
    sides = numpy.concatenate([corners[:, [i, (i + 1) % 4]] for i in range(4)])
    sides = numpy.unique(numpy.sort(sides, axis=1), axis=0)
    seen = view.project(surface.points[sides])
    depth = seen[:, :, 2].mean(axis=1)
    order = depth.argsort()
    tone = 0.55 - 0.5 * (depth[order] - depth.min()) / max(numpy.ptp(depth), 1e-12)
    axes.add_collection(LineCollection(seen[order][:, :, :2], lw=0.35,
                                       colors=numpy.stack([tone * 0.5, tone * 0.8, tone + 0.3], axis=1)))


def scale_bar(axes, length=5):
    axes.set_ylim(axes.get_ylim()[0] - 1.6, axes.get_ylim()[1])
    x, y = axes.get_xlim()[0] + 1.0, axes.get_ylim()[0] + 0.3
    axes.plot([x, x + length], [y, y], color="black", lw=2)
    axes.text(x + 0.5 * length, y + 0.3, f"{length} mm", ha="center", va="bottom")


def figure_5(file, run, vessel):
    """Three stages of the opening."""
    frames = [data.get("file") for data in
              ElementTree.parse(run.folder / "frames.pvd").iter("DataSet")]
    chosen = [frames[round(share * (len(frames) - 1))] for share in (0.3, 0.65, 1.0)]
    triangles = read_stl(vessel)
    view = View(triangles)
    figure, all_axes = plt.subplots(1, 3, figsize=(12, 4.2), constrained_layout=True)
    for axes, frame, letter in zip(all_axes, chosen, "ABC"):
        draw_far_wall(axes, view, triangles)
        draw_wires(axes, view, Surface(run.folder / frame))
        axes.set_title(letter, loc="left", fontweight="bold")
        scale_bar(axes)
    save(figure, file)


def figure_7(file, shown, vessel):
    """Density increase on the device, without and with push."""
    triangles = read_stl(next(iter(shown.values()))[0].summary["case"]["vessel"]["surface"])
    view = View(triangles)
    norm = Normalize(-50, 350)
    names = ["4mm", "4mm_push"]
    figure, all_axes = plt.subplots(1, 2, figsize=(10, 4.6), constrained_layout=True)
    for axes, name in zip(all_axes, names):
        surface = shown[name][0].surface()
        draw_far_wall(axes, view, triangles)
        draw_cells(axes, view, surface, 100 * surface.at_polygons["surface_density_increase"], norm)
        axes.set_title(TITLES[name])
        scale_bar(axes)
    figure.colorbar(ScalarMappable(norm, COLOURS), ax=all_axes, shrink=0.7, extend="both",
                    label="density increase (%)")
    save(figure, file)


def figure_10(file, runs, vessels):
    """Devices in a tortuous artery and across a giant aneurysm."""
    norm = Normalize(-50, 100)
    figure, all_axes = plt.subplots(1, 2, figsize=(11, 5), constrained_layout=True)
    for axes, (name, run), letter in zip(all_axes, runs.items(), "AB"):
        triangles = read_stl(vessels[name])
        view = View(triangles)
        surface = run.surface()
        draw_far_wall(axes, view, triangles)
        draw_cells(axes, view, surface, 100 * surface.at_polygons["surface_density_increase"], norm)
        axes.set_title(f"{letter}  {name}", loc="left", fontweight="bold")
        scale_bar(axes)
    figure.colorbar(ScalarMappable(norm, COLOURS), ax=all_axes, shrink=0.7, extend="both",
                    label="density increase (%)")
    save(figure, file)


# ---- unfolded maps -----------------------------------------------------------------------------

# field, title, range; the range of the radial expansion is the device's own, as in the paper.
MAPS = [("wall_contact", "wall contact", (0, 1)),
        ("surface_density_increase", "density increase (%)", (-50, 350)),
        ("contact_force", "contact force on a crossing (mN)", (0, 2)),
        ("radial_expansion", "radial expansion (mm)", None)]
TO_SHOWN = {"wall_contact": 1, "surface_density_increase": 100, "contact_force": 1e3,
            "radial_expansion": 1e3}
HALF_STRETCH = 5.0  # of the vessel shown on both sides of the neck's centre [mm]


def figure_8(file, shown, vessel, arc_length):
    unfolded_maps(file, {n: shown[n] for n in ("4mm", "4mm_push")}, vessel, arc_length, (1.8, 2.2))


def figure_9(file, shown, vessel, arc_length):
    unfolded_maps(file, {n: shown[n] for n in ("5mm", "5mm_push")}, vessel, arc_length, (1.8, 2.6))


def unfolded_maps(file, shown, vessel, arc_length, expansions):
    """Rows: without and with push. The same stretch of the vessel, on the unfolded free device."""
    centre = float(vessel["sac"][0]["position"].split()[0])
    maps = {name: UnfoldedDevice(run, case, centre, arc_length)
            for name, (run, case) in shown.items()}
    width = next(iter(maps.values())).circumference
    heights = [m.height for m in maps.values()]
    inch = 2.3 / width
    figure, all_axes = plt.subplots(
        len(maps), len(MAPS), figsize=(4 * 2.9, inch * sum(heights) + 1.6), squeeze=False,
        gridspec_kw={"height_ratios": heights}, constrained_layout=True)
    for row, (name, device) in zip(all_axes, maps.items()):
        for column, (field, title, limits) in enumerate(MAPS):
            axes = row[column]
            colours = ListedColormap(["#f5e79e", "#1b2a6b"]) if field == "wall_contact" else COLOURS
            norm = Normalize(*(limits or expansions))
            axes.add_collection(PolyCollection(
                device.corners, array=TO_SHOWN[field] * device.values(field), norm=norm,
                cmap=colours, lw=0.2, edgecolors="face"))
            axes.set(xlim=(0, width), ylim=(0, device.height), aspect="equal")
            if name == list(maps)[0]:
                axes.set_title(title)
            if name == list(maps)[-1]:
                axes.set_xlabel("around (mm)")
                is_flag = field == "wall_contact"
                bar = figure.colorbar(ScalarMappable(norm, colours), ax=all_axes[:, column],
                                      location="bottom", shrink=0.85,
                                      extend="neither" if is_flag else "both")
                if is_flag:
                    bar.set_ticks([0.25, 0.75], labels=["free", "in contact"])
        row[0].set_ylabel(f"{TITLES[name]}\nalong (mm)")
    save(figure, file)


class UnfoldedDevice:
    """The cells of unrolled.vtp near the neck; the side opposite to the neck is in the middle."""

    def __init__(self, run, case, centre, arc_length):
        self.surface = run.surface("unrolled.vtp")
        corners = self.surface.points[self.surface.polygons][:, :, :2]
        self.circumference = numpy.pi * float(case["device"]["diameter"].split()[0])
        place = arc_length(case, corners[:, :, 1].mean(axis=1))
        self.chosen = numpy.abs(place - centre) < HALF_STRETCH
        near = numpy.abs(place - centre) < 1.5
        free = near & (self.surface.polygon_means("wall_contact") < 0.5)
        angle = 2 * numpy.pi * corners[:, :, 0].mean(axis=1) / self.circumference
        neck = numpy.angle(numpy.exp(1j * angle[free]).sum()) if free.any() else 0.0
        corners = corners[self.chosen]
        corners[:, :, 0] -= neck / (2 * numpy.pi) * self.circumference
        turns = numpy.floor(corners[:, :, 0].mean(axis=1) / self.circumference)
        corners[:, :, 0] -= (turns * self.circumference)[:, None]
        corners[:, :, 1] -= corners[:, :, 1].min()
        self.corners = corners
        self.height = corners[:, :, 1].max()

    def values(self, field):
        surface = self.surface
        at = (surface.at_polygons[field] if field in surface.at_polygons
              else surface.polygon_means(field))
        return at[self.chosen]

#pragma once

namespace braidzone {

/// Shear-thinning blood after Carreau and Yasuda:
///
///     mu = mu_inf + (mu_0 - mu_inf) (1 + (lambda g)^a)^((n - 1) / a)
///
/// with the shear rate g. The defaults are blood's as fitted by Cho and Kensey 1991 (Biorheology
/// 28:241-262, doi 10.3233/BIR-1991-283-415).
struct CarreauYasuda {
    double zero_shear_viscosity = 0.056;        ///< mu_0 [Pa s]
    double infinite_shear_viscosity = 3.45e-3;  ///< mu_inf [Pa s]
    double relaxation_time = 1.902;             ///< lambda [s]
    double power_index = 0.22;                  ///< n [-]
    double yasuda_exponent = 1.25;              ///< a [-]; 2 is Carreau's own model
};

/// The viscosity at a shear rate.
/// @param shear_rate  sqrt(2 S:S), S the rate of strain [1/s]; >= 0
/// @return [Pa s]
double viscosity(const CarreauYasuda& blood, double shear_rate);

/// @throws InputError if a constant is out of range: mu_0 > mu_inf > 0, lambda > 0, 0 < n < 1,
///         a > 0
void validate(const CarreauYasuda& blood);

}  // namespace braidzone

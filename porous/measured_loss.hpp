#pragma once

#include "core/fluid.hpp"
#include "porous/range_check.hpp"
#include "porous/rhombus.hpp"
#include "porous/sheet_loss.hpp"

#include <filesystem>
#include <vector>

namespace braidzone {

/// The loss of a braid of one density on a test bench.
struct MeasuredBraid {
    double metal_coverage = 0.0;    ///< [-]; 0 < . < 1
    double wire_spacing = 0.0;      ///< perpendicular distance of a family's wires [m]
    SheetLoss loss;                 ///< fitted to the measured drops, in the bench's fluid
    double fit_error = 0.0;         ///< largest relative difference of fit and measurement [-]
    double highest_velocity = 0.0;  ///< measured [m/s]
};

/// Losses measured on a bench (as Csippa et al. 2020, doi 10.1007/s13239-019-00445-y, did), carried
/// over to other densities, spacings and fluids.
///
/// A braid of wires d every p loses a = mu g(s) / p and b = rho h(s), s = d / p (exact for slow
/// flow, and for b at one Reynolds number). How g and h rise with the density is known from
/// wire-resolved flow; what a bench adds is by how much the real braid differs. So each measured
/// braid gives two factors
///
///     f_a = a_measured / a_braid-stokes,   f_b = b_measured / b_braid-stokes
///
/// for an orthogonal braid of its coverage and spacing in the bench's fluid, and
///
///     a = f_a(coverage) a_braid-stokes,   b = f_b(coverage) b_braid-stokes
///
/// of the local rhombus in the case's fluid, with f linear in the metal coverage between measured
/// braids and constant beyond. One measured density is enough; several correct the slope.
struct MeasuredLaw {
    static constexpr const char* name = "measured";
    std::filesystem::path table;        ///< where the braids come from
    Fluid bench_fluid;                  ///< in which they were measured
    std::vector<MeasuredBraid> braids;  ///< by increasing metal coverage; at least one
};

/// Reads a table of pressure drops: a CSV file with the header
/// `metal_coverage,wire_spacing_um,velocity_mm_s,pressure_drop_Pa`, then one measurement a line.
/// Lines of the same coverage and spacing belong to one braid; a v + b v^2 is fitted to each
/// (`two_term_fit`).
/// @throws IoError if the file cannot be read; InputError with the number of the line for another
///         header or a line without four such numbers, for a braid measured at one velocity only
///         (nothing tells a from b), for one whose fit is no loss, or for two braids of the same
///         coverage
MeasuredLaw read_measured_law(const std::filesystem::path& table, const Fluid& bench_fluid);

/// @throws InputError if the law holds no braid
SheetLoss sheet_loss(const MeasuredLaw& law, const Rhombus& rhombus, const Fluid& fluid);

/// Measured are the coverages between the lowest and the highest, with a tenth of them as slack,
/// and velocities up to the highest.
std::vector<RangeCheck> range_checks(const MeasuredLaw& law, const Rhombus& rhombus,
                                     const Fluid& fluid);

}  // namespace braidzone

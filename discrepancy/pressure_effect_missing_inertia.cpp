#include "discrepancy/pressure_effects.hpp"
#include "porous/braid_stokes.hpp"

namespace braidzone {

/// The quadratic part of the loss is missing, or another than the law's.
///
/// Over the braid-stokes law's, which is within 30 % of wire-resolved flow; prior 0.5, so that a
/// law without one lies at two standard deviations. Key: bench.added_inertia.
PressureEffect missing_inertia_effect(const PressureBench& base)
{
    PressureBench single = base;
    single.second_layer = 0.0;
    const double present = bench_loss(single).quadratic /
                           braid_stokes_quadratic(bench_rhombus(base), base.fluid.density);
    return {{.name = "missing_inertia",
             .title = "the inertial part of the loss is missing, or other than the law's",
             .parameters = {normal_parameter("added_inertia", "1", 0.0, 0.5, -present, 3.0)},
             .starts = {{0.0}},
             .needs_simulation = true,
             .separated_by = "points at higher velocities, or a run with a less viscous fluid"},
            [](const PressureBench& before, const std::vector<double>& x) {
                PressureBench bench = before;
                bench.added_inertia += x[0];
                return bench;
            }};
}

}  // namespace braidzone

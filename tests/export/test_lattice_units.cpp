#include "core/error.hpp"
#include "export/lattice_units.hpp"
#include "support/lattices.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace braidzone {
namespace {

// dx = 0.2 mm, U = 0.6 m/s, u_lu = 0.05: dt = 0.05 2e-4 / 0.6 = 1.6667e-5 s. nu = 4e-6 m^2/s:
// nu_lu = 4e-6 1.6667e-5 / 4e-8 = 1.6667e-3, tau = 0.505. a = 4e-6 2.5e9 1.6667e-5 = 0.16667,
// b = 7168 1e-4 = 0.7168.
TEST(ProposeUnits, MatchesHandCalculation)
{
    const LatticeUnits units =
        propose_units(test::asymmetric_lattice(), Fluid{1000.0, 4e-3}, LatticeFlowOptions{});
    EXPECT_NEAR(units.time_step, 1.66667e-5, 1e-10);
    EXPECT_NEAR(units.viscosity_lu, 1.66667e-3, 1e-8);
    EXPECT_NEAR(units.relaxation_time_lu, 0.505, 1e-7);
    EXPECT_NEAR(units.mach, 0.0866025, 1e-7);
    EXPECT_NEAR(units.largest_drag_lu, 0.166667, 1e-6);
    EXPECT_NEAR(units.largest_inertia_lu, 0.7168, 1e-9);
}

TEST(ProposeUnits, RefusesVelocitiesOutOfRange)
{
    for (const LatticeFlowOptions& options :
         {LatticeFlowOptions{0.0, 0.05}, LatticeFlowOptions{std::nan(""), 0.05},
          LatticeFlowOptions{0.6, 0.0}, LatticeFlowOptions{0.6, 0.3}}) {
        EXPECT_THROW(propose_units(test::asymmetric_lattice(), Fluid{}, options), ConfigError);
    }
}

}  // namespace
}  // namespace braidzone

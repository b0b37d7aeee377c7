// Density and force of devices of another simulator (support/hidden) in which no effect is hidden,
// against the deployment: what the noise floor allows for.

#include "discrepancy/blind/case_folder.hpp"
#include "discrepancy/contact_force.hpp"
#include "discrepancy/density_field.hpp"
#include "discrepancy/noise_floor.hpp"
#include "support/hidden/hidden_density.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace braidzone {

TEST(NoiseFloor, CoversDensityAndForceWhereNothingIsHidden)
{
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    constexpr int num_devices = 8;
    double local = 0.0, mean = 0.0, force = 0.0;  // mean squares, relative
    for (std::uint32_t seed = 1; seed <= num_devices; ++seed) {
        const hidden::HiddenCase made = hidden::random_case({}, seed);
        std::mt19937 random(seed);
        const DensityMap map = hidden::counted_pores(
            made.device, made.true_device,
            {.relative_sd = 1e-9, .scale_sd = 0.0, .unseen_share = 0.0}, random);
        const Simulation base = simulate(blind::believed_model(made.belief),
                                         blind::believed_lumen(made.belief.phantom));
        const DensityField field = make_density_field(map, {}, base);
        ASSERT_EQ(field.places.size(), map.places.size());
        Eigen::ArrayXd off(field.scale.size());
        for (Eigen::Index i = 0; i < off.size(); ++i)
            off[i] = field.places[static_cast<std::size_t>(i)].value / field.scale[i] - 1.0;
        local += (off - off.mean()).square().mean() / num_devices;
        mean += off.mean() * off.mean() / num_devices;
        const double ratio = hidden::wall_force(made.device, -everywhere, everywhere) /
                             contact_force(base.deployment, -everywhere, everywhere);
        force += (ratio - 1.0) * (ratio - 1.0) / num_devices;
    }
    const NoiseFloor floor;
    // Eight devices tell a mean square to a factor of two.
    EXPECT_LT(std::sqrt(local), 1.4 * floor.density_sd);
    EXPECT_GT(std::sqrt(local), 0.5 * floor.density_sd);
    EXPECT_LT(std::sqrt(mean), floor.density_scale_sd);
    EXPECT_LT(std::sqrt(force), floor.force_sd);
    EXPECT_GT(std::sqrt(force), 0.3 * floor.force_sd);
}

}  // namespace braidzone

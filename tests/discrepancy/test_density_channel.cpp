#include "discrepancy/blind/case_folder.hpp"
#include "discrepancy/contact_force.hpp"
#include "discrepancy/density_field.hpp"
#include "support/hidden/hidden_density.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace braidzone {

TEST(Scratch, Floor)
{
    constexpr double inf = std::numeric_limits<double>::infinity();
    double sum_local = 0, sum_mean = 0, mean_mean = 0, sum_force = 0, mean_force = 0;
    const int num = 24;
    for (int seed = 1; seed <= num; ++seed) {
        const hidden::HiddenCase made = hidden::random_case({}, seed);
        std::mt19937 random(seed);
        const DensityMap map =
            hidden::counted_pores(made.device, made.true_device, {.relative_sd = 1e-6}, random);
        const Lumen lumen = blind::believed_lumen(made.belief.phantom);
        const Simulation base = simulate(blind::believed_model(made.belief), lumen);
        const DensityField field = make_density_field(map, {}, base);
        Eigen::VectorXd r = simulated_density(field, {}, base);
        for (Eigen::Index i = 0; i < r.size(); ++i)
            r[i] = field.places[static_cast<std::size_t>(i)].value / r[i] - 1.0;
        const double mean = r.mean();
        const double local = std::sqrt((r.array() - mean).square().mean());
        const double force = hidden::wall_force(made.device, -inf, inf),
                     simulated = contact_force(base.deployment, -inf, inf);
        fmt::print(
            "{} places {} mean {:.4f} local {:.4f} max {:.3f} force {:.4f} sim {:.4f} ratio "
            "{:.3f}\n",
            seed, r.size(), mean, local, r.cwiseAbs().maxCoeff(), force, simulated,
            force / simulated);
        sum_local += local * local / num;
        sum_mean += mean * mean / num;
        mean_mean += mean / num;
        const double lf = std::log(force / simulated);
        sum_force += lf * lf / num;
        mean_force += lf / num;
    }
    fmt::print("local {:.4f} mean rms {:.4f} bias {:.4f} force rms {:.3f} bias {:.3f}\n",
               std::sqrt(sum_local), std::sqrt(sum_mean), mean_mean, std::sqrt(sum_force),
               mean_force);
}

}  // namespace braidzone

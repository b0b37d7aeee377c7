// What a diagnosis takes for the trace of an effect must not be the simulation's own scatter: along
// each parameter of each effect the surface moves smoothly, by patches of 0.8 mm by 30 degrees.

#include "core/phantom_file.hpp"
#include "discrepancy/discrepancy_field.hpp"
#include "discrepancy/effect.hpp"
#include "support/devices_of_any_size.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <utility>

namespace braidzone {
namespace {

/// Middle of the neck on the centerline [m].
constexpr double neck = 15e-3;
/// Step of a parameter over its prior standard deviation.
constexpr double step_ratio = 1e-2;
constexpr double largest_scatter = 3e-6;  // [m]

Lumen sidewall()
{
    const PhantomVessel made = make_phantom(read_phantom(TomlTable::read_file(
        std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases/sidewall_aneurysm/phantom.toml")));
    Vessel vessel = make_vessel(made.wall, LengthUnit{});
    WallTree wall(vessel);
    return {std::move(vessel), std::move(wall), resample(made.centerline)};
}

/// Values at which an effect is seen: its last start, over the neck if it has a place.
std::vector<double> typical_values(const Effect& effect, const EffectSetting& setting)
{
    std::vector<double> values = effect.starts(setting).back();
    const auto parameters = effect.parameters(setting);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (parameters[i].name == "centre") values[i] = neck;
    }
    return values;
}

/// The movement of the surface, patch by patch, against that of a base model.
class SurfaceMovement {
public:
    SurfaceMovement(const Lumen& lumen, const EffectSetting& setting)
        : lumen_(lumen), setting_(setting), base_(simulate(setting.base, lumen))
    {
        points_ = base_.deployment.nodes;
        field_ = make_discrepancy_field(points_, setting.base.imaging, base_);
    }

    /// Medians of the patches [m].
    Eigen::VectorXd operator()(const Effect& effect, const std::vector<double>& values) const
    {
        const Model model = effect.apply(setting_, values);
        return patch_gaps(points_, field_, model.imaging, simulate(model, lumen_).surface,
                          base_.surface);
    }

private:
    const Lumen& lumen_;
    const EffectSetting& setting_;
    Simulation base_;
    std::vector<Vec3> points_;
    DiscrepancyField field_;
};

}  // namespace

// Of three values with independent scatter sigma the second difference has sqrt(6) sigma; what a
// smooth curve adds to it is of the second order in the step, a ten-thousandth of what a parameter
// does over its prior.
TEST(Effects, MoveTheSurfaceSmoothlyAlongEachParameter)
{
    const Lumen lumen = sidewall();
    EffectSetting setting;
    setting.base.device = test::pipeline(4e-3);
    setting.base.device.force_scale = 61.0;  // as the 4 mm device of the library
    setting.base.landing_distal = 25e-3;
    setting.from = 5e-3;
    setting.to = 25e-3;
    setting.middle = section_at(lumen.centerline, neck).origin;
    const SurfaceMovement movement(lumen, setting);
    for (const Effect& effect : effect_catalogue()) {
        const std::vector<double> values = typical_values(effect, setting);
        const Eigen::VectorXd here = movement(effect, values);
        const auto parameters = effect.parameters(setting);
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::vector<double> below = values, above = values;
            below[i] -= step_ratio * parameters[i].prior_sd;
            above[i] += step_ratio * parameters[i].prior_sd;
            const Eigen::VectorXd low = movement(effect, below), high = movement(effect, above);
            const auto count = static_cast<double>(here.size());
            const double scatter = (low - 2.0 * here + high).norm() / std::sqrt(6.0 * count);
            fmt::print("{:<28} {:<10} scatter {:.3f} um, moves {:.3f} um a step\n", effect.name,
                       parameters[i].name, 1e6 * scatter,
                       1e6 * (high - low).norm() / (2.0 * std::sqrt(count)));
            EXPECT_LT(scatter, largest_scatter) << effect.name << " " << parameters[i].name;
        }
    }
}

}  // namespace braidzone

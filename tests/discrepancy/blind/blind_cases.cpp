// Hidden cases: for each, a random sidewall aneurysm and device, measured by
// support/hidden_measurement.hpp with one effect (or none, or one that the catalogue does not know)
// hidden in it, and diagnosed as a user would. One line of CSV a case; see README.md beside this.
//
//     blind_cases EFFECT FIRST_SEED COUNT [NOISE.json]
//     blind_cases calibrate FIRST_SEED COUNT > NOISE.json
//
// blind_cases hidden_push FOLDER writes the data of cases/hidden_push instead.

#include "core/centerline_io.hpp"
#include "core/phantom_file.hpp"
#include "discrepancy/diagnosis.hpp"
#include "discrepancy/noise_calibration.hpp"
#include "support/devices_of_any_size.hpp"
#include "support/hidden_measurement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <fstream>
#include <numbers>
#include <random>
#include <string>

namespace braidzone::test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// What the user of one case believes.
struct Belief {
    Phantom phantom;
    FlowDiverter device;
    double landing = 0.0;
};

Belief random_belief(std::mt19937& random)
{
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Belief belief;
    const double radius = between(1.82e-3, 1.95e-3);
    belief.phantom.segments = {
        {8e-3, 0.0, 0.0}, {14e-3, between(20.0, 60.0) * degree, 0.0}, {8e-3, 0.0, 0.0}};
    belief.phantom.proximal_radius = radius;
    belief.phantom.distal_radius = radius - between(0.0, 0.1e-3);
    belief.phantom.blend_radius = 0.4e-3;
    belief.phantom.sacs = {{.position = between(13.5e-3, 16.5e-3),
                            .direction = 180.0 * degree,
                            .diameter = 7e-3,
                            .height = 7e-3,
                            .neck = between(4e-3, 5e-3)}};
    belief.device = pipeline(4e-3);
    belief.device.force_scale = 61.0;  // of the library
    belief.landing = between(24.5e-3, 25.5e-3);
    return belief;
}

/// A place away from the device's ends.
double along_device(const Belief& belief, std::mt19937& random)
{
    return std::uniform_real_distribution<double>(belief.landing - 14e-3,
                                                  belief.landing - 6e-3)(random);
}

Hidden random_effect(const std::string& effect, const Belief& belief, const Lumen& lumen,
                     std::mt19937& random)
{
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double sign = between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
    const auto direction = [&](double size) {
        const Vec3 any(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
        return Vec3(size * any.normalized());
    };
    const double neck = *belief.phantom.sacs.front().position;
    Hidden hidden;
    if (effect == "local_push") {
        hidden.centre = neck + between(-1e-3, 1e-3);
        hidden.spacing =
            smooth_spacing(hidden.centre, between(1.4e-3, 2.0e-3), -between(0.3, 0.66));
    } else if (effect == "local_pull") {
        hidden.centre = along_device(belief, random);
        hidden.spacing = smooth_spacing(hidden.centre, between(1.4e-3, 2.0e-3), between(0.2, 0.45));
    } else if (effect == "nominal_diameter") {
        // A narrower one would lie loose in a vessel of this width.
        hidden.diameter_change = sign > 0.0 ? between(0.2e-3, 0.4e-3) : -between(0.1e-3, 0.2e-3);
    } else if (effect == "landing_offset") {
        hidden.landing_offset = sign * between(1e-3, 2e-3);
    } else if (effect == "vessel_offset") {
        hidden.radius_change = sign * between(0.08e-3, 0.15e-3);
    } else if (effect == "blooming") {
        hidden.blooming = sign * between(0.08e-3, 0.18e-3);
    } else if (effect == "registration") {
        hidden.shift = direction(between(0.3e-3, 0.6e-3));
        hidden.rotation = direction(between(2.0, 4.0) * degree);
    } else if (effect == "wall_compliance") {
        hidden.wall_stiffness = 4400.0 / between(0.07e-3, 0.15e-3);
    } else if (effect == "braid_ratio") {
        hidden.ratio_change = sign * between(0.1, 0.2);
    } else if (effect == "dent" || effect == "oval") {
        const CrossSection at = section_at(lumen.centerline, along_device(belief, random));
        const double angle = between(0.0, 2.0 * std::numbers::pi);
        const Vec3 out = std::cos(angle) * at.normal + std::sin(angle) * at.binormal;
        const double size = between(0.15e-3, 0.3e-3);
        if (effect == "dent") {
            const Vec3 place = at.origin + 1.9e-3 * out;
            hidden.dent = [=](const Vec3& p) {
                return -size * std::exp(-0.5 * (p - place).squaredNorm() / 1.2e-6);
            };
        } else {
            hidden.dent = [=](const Vec3& p) {
                const Vec3 away = p - at.origin;
                const double cosine = away.normalized().dot(out);
                const double s = away.dot(at.tangent);
                return size * (2.0 * cosine * cosine - 1.0) * std::exp(-0.5 * s * s / 9e-6);
            };
        }
    } else if (effect != "none") {
        throw std::invalid_argument("effect " + effect + " is not known");
    }
    return hidden;
}

Lumen believed_lumen(const Phantom& phantom)
{
    PhantomVessel made = make_phantom(phantom);
    Vessel vessel = make_vessel(made.wall, LengthUnit{});
    WallTree wall(vessel);
    return {std::move(vessel), std::move(wall), resample(made.centerline)};
}

Model model_of(const Belief& belief)
{
    Model model;
    model.device = belief.device;
    model.landing_distal = belief.landing;
    return model;
}

/// A measurement without an effect, as a set to learn from.
CalibrationSet calibration_set(std::uint32_t seed)
{
    std::mt19937 random(seed);
    const Belief belief = random_belief(random);
    const HiddenMeasurement measured =
        hidden_measurement(belief.phantom, belief.device, belief.landing, {}, seed + 1000000);
    const Simulation base = simulate(model_of(belief), believed_lumen(belief.phantom));
    CalibrationSet set;
    set.observations = {measured.points, make_discrepancy_field(measured.points, {}, base),
                        measured.ends};
    set.residuals = residuals(set.observations, base, {});
    return set;
}

void print_noise_floor(std::uint32_t first, int count)
{
    std::vector<CalibrationSet> sets;
    for (int i = 0; i < count; ++i)
        sets.push_back(calibration_set(first + static_cast<std::uint32_t>(i)));
    fmt::print("{}", noise_floor_text(calibrate_noise_floor(sets)));
}

void print_case(const std::string& effect, std::uint32_t seed, const NoiseFloor& floor)
{
    std::mt19937 random(seed);
    const Belief belief = random_belief(random);
    const Lumen lumen = believed_lumen(belief.phantom);
    const Hidden hidden = random_effect(effect, belief, lumen, random);
    const HiddenMeasurement measured =
        hidden_measurement(belief.phantom, belief.device, belief.landing, hidden, seed + 1000000);
    DiagnoseOptions options;
    options.floor = floor;
    const Diagnosis found = diagnose(model_of(belief), lumen, measured.points, measured.ends,
                                     effect_catalogue(), options);
    double location_error = std::nan("");
    const Explanation& explanation = found.explanation;
    if (explanation.best && !hidden.spacing.empty()) {
        const FittedEffect& first = explanation.fits[*explanation.best].effects.front();
        if (first.values.size() == 3) location_error = 1e3 * (first.values[1] - hidden.centre);
    }
    std::string evidence, answers;
    for (const NamedEvidence& named : explanation.named) {
        evidence += fmt::format(" {}:{:.1f}/{:.1f}", fmt::join(named.effects, "+"),
                                named.log_evidence, named.log_evidence_unknown);
    }
    for (const Answer& answer : explanation.verdict.answers)
        answers += fmt::format("{}{}", answers.empty() ? "" : "|", fmt::join(answer.effects, "+"));
    fmt::print("{},{},{},{},{},{:.2f},{:.4f},{:.4f},{:.4f},{:.2f},{},U:{:.1f}{}\n", effect, seed,
               name_of(explanation.verdict.finding), answers,
               explanation.verdict.has_unexplained_rest ? "rest" : "-", location_error,
               1e3 * found.everywhere.before.rms, 1e3 * found.everywhere.after.rms,
               1e3 * found.everywhere.floor.rms, found.background, explanation.num_runs,
               explanation.log_evidence_unknown, evidence);
    std::fflush(stdout);
}

/// The paper's story: 66 % off the ring spacing in front of the neck.
void write_hidden_push(const std::filesystem::path& folder)
{
    const std::filesystem::path source = std::filesystem::path(BRAIDZONE_SOURCE_DIR);
    const Phantom phantom =
        read_phantom(TomlTable::read_file(source / "cases/sidewall_aneurysm/phantom.toml"));
    FlowDiverter device = pipeline(4e-3);
    device.force_scale = 61.0;
    const HiddenMeasurement measured = hidden_measurement(
        phantom, device, 25e-3, {.spacing = smooth_spacing(15e-3, 1.8e-3, -0.66)}, 2020,
        {.num_points = 2500});
    std::ofstream points(folder / "measured.csv");
    points << "x_mm,y_mm,z_mm\n";
    for (const Vec3& p : measured.points)
        points << fmt::format("{:.3f},{:.3f},{:.3f}\n", 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z());
    std::ofstream ends(folder / "measured.toml");
    ends << "# End markers of the measured device, arc lengths on the vessel's centerline.\n";
    for (std::size_t i = 0; i < 2; ++i) {
        ends << fmt::format("{0} = \"{1:.2f} mm\"\n{0}_sd = \"{2:.2f} mm\"\n", scalar_names[i],
                            1e3 * measured.ends.values[i]->value,
                            1e3 * measured.ends.values[i]->sd);
    }
}

}  // namespace
}  // namespace braidzone::test

int main(int argc, char** argv)
{
    using namespace braidzone::test;
    if (argc == 3 && std::string(argv[1]) == "hidden_push") {
        write_hidden_push(argv[2]);
        return 0;
    }
    if (argc != 4 && argc != 5) {
        fmt::print(stderr, "usage: blind_cases EFFECT FIRST_SEED COUNT [NOISE]\n");
        return 2;
    }
    const auto first = static_cast<std::uint32_t>(std::atoi(argv[2]));
    if (std::string(argv[1]) == "calibrate") {
        print_noise_floor(first, std::atoi(argv[3]));
        return 0;
    }
    const auto floor = argc == 5 ? braidzone::read_noise_floor(argv[4]) : braidzone::NoiseFloor{};
    for (int i = 0; i < std::atoi(argv[3]); ++i)
        print_case(argv[1], first + static_cast<std::uint32_t>(i), floor);
    return 0;
}

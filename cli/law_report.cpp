#include "cli/law_report.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>

namespace braidzone {
namespace {

/// Velocities of the table [m/s]: what flows through necks, and the fastest of wire-resolved flow.
constexpr std::array<double, 4> velocities{0.01, 0.05, 0.1, 0.2};

}  // namespace

std::string law_table(const std::vector<LawComparison>& laws)
{
    std::string text = fmt::format("  {:<14}{:>10}{:>14}", "law", "a [Pa s/m]", "b [Pa s2/m2]");
    for (const double velocity : velocities)
        text += fmt::format("{:>12}", fmt::format("{:.3g} mm/s", 1e3 * velocity));
    text += fmt::format("{:>9}\n", "a ratio");
    for (const LawComparison& law : laws) {
        text +=
            fmt::format("  {:<14}{:>10.4g}{:>14.4g}", law.law, law.mean.linear, law.mean.quadratic);
        for (const double velocity : velocities)
            text += fmt::format("{:>9.3g} Pa", pressure_drop(law.mean, velocity));
        text += fmt::format("{:>9.2f}\n", law.ratio);
    }
    for (const LawComparison& law : laws) {
        for (const std::string& warning : law.warnings)
            text += fmt::format("  note: {}\n", warning);
    }
    return text;
}

void write_law_table(const std::filesystem::path& path, const std::vector<LawComparison>& laws)
{
    std::ofstream file(path);
    file << "law,a_Pa_s_per_m,b_Pa_s2_per_m2";
    for (const double velocity : velocities)
        file << fmt::format(",drop_at_{:.3g}_mm_s_Pa", 1e3 * velocity);
    file << ",a_over_recommended,resistance_integral_m\n";
    for (const LawComparison& law : laws) {
        file << fmt::format("{},{:.9g},{:.9g}", law.law, law.mean.linear, law.mean.quadratic);
        for (const double velocity : velocities)
            file << fmt::format(",{:.9g}", pressure_drop(law.mean, velocity));
        file << fmt::format(",{:.9g},{:.9g}\n", law.ratio, law.resistance_integral);
    }
    if (!file.flush()) throw IoError(fmt::format("{} cannot be written", path.string()));
}

}  // namespace braidzone

#include "deploy/force_curve.hpp"

#include "core/repeat_curve.hpp"

namespace braidzone {

ForceCurve read_force_curve(const std::filesystem::path& path)
{
    const RepeatCurve read =
        read_repeat_curve(path, {"force curve",
                                 "displacement_mm,force_1_mN,force_2_mN,... (or _um, _m; _uN, _N)",
                                 {"displacement", {{"_mm", 1e-3}, {"_um", 1e-6}, {"_m", 1.0}}},
                                 {"force", {{"_mN", 1e-3}, {"_uN", 1e-6}, {"_N", 1.0}}}});
    ForceCurve curve;
    curve.num_repeats = read.num_repeats;
    curve.deviation = read.deviation;
    for (std::size_t i = 0; i < read.means.size(); ++i)
        curve.points.push_back({read.abscissae[i], read.means[i]});
    return curve;
}

}  // namespace braidzone

#include "porous/pressure_curve.hpp"

namespace braidzone {

RepeatCurve read_pressure_curve(const std::filesystem::path& path)
{
    return read_repeat_curve(
        path, {"pressure-drop curve",
               "velocity_m_s,pressure_drop_1_Pa,pressure_drop_2_Pa,... (or _mm_s, _cm_s; _mmHg, "
               "_mbar)",
               {"velocity", {{"_mm_s", 1e-3}, {"_cm_s", 1e-2}, {"_m_s", 1.0}}},
               {"pressure_drop", {{"_Pa", 1.0}, {"_mmHg", 133.322387415}, {"_mbar", 100.0}}}});
}

}  // namespace braidzone

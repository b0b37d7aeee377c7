#pragma once

#include <string>

namespace braidzone {

/// What the axes of a measured curve hold, and the units in which they are shown.
struct CurveLabels {
    std::string curve;          ///< "force curve"
    std::string abscissa;       ///< "displacement"
    std::string abscissa_unit;  ///< "mm"
    double abscissa_si = 1.0;   ///< of that unit
    std::string ordinate;       ///< "force"
    std::string ordinate_unit;  ///< "mN"
    double ordinate_si = 1.0;
};

}  // namespace braidzone

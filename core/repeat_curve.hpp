#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {

/// What a column of a curve holds, and the units that its name may end in.
struct CurveColumn {
    std::string quantity;                               ///< "displacement"
    std::vector<std::pair<std::string, double>> units;  ///< ending and SI value, {"_mm", 1e-3}
};

/// A kind of curve as a file of comma-separated values.
struct CurveFormat {
    std::string name;      ///< "force curve"
    std::string expected;  ///< its header, for messages
    CurveColumn abscissa;  ///< first column; increases from 0 or above
    CurveColumn ordinate;  ///< of all others, one a repeat
};

/// A measured curve: the mean of its repeats.
struct RepeatCurve {
    std::vector<double> abscissae;  ///< SI, increasing
    std::vector<double> means;      ///< SI, one an abscissa
    int num_repeats = 1;
    /// Standard deviation of a repeat about the mean of the repeats [SI], pooled over all points; 0
    /// for a single curve.
    double deviation = 0.0;
};

/// Reads a curve: a header that names the columns with their units, then one point a line.
/// @throws IoError if the file cannot be read; InputError with the number of the line if it is not
///         such a file, and if it has fewer than four points or no mean above zero
RepeatCurve read_repeat_curve(const std::filesystem::path& path, const CurveFormat& format);

}  // namespace braidzone

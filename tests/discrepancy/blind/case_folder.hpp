#pragma once

#include "discrepancy/lumen.hpp"
#include "discrepancy/measured_scalars.hpp"
#include "discrepancy/model.hpp"
#include "support/hidden/hidden_case.hpp"

#include <filesystem>
#include <string>
#include <vector>

// One hidden case on disk. Its data folder holds what a user would have:
//
//     phantom.toml   the believed vessel, as `braidzone phantom` reads it
//     device.toml    diameter, length, landing_distal
//     measured.csv   points of the scan
//     measured.toml  its end markers
//     density.csv    pores counted in squares
//     further.toml   the force on the wall
//
// and its truth stands in a file of another folder, `<case>.json`.

namespace braidzone::blind {

namespace fs = std::filesystem;

/// What a diagnosis may know of a case.
struct CaseData {
    Model model;
    Lumen lumen;
    std::vector<Vec3> points;  ///< [m]
    MeasuredScalars scalars;
    DensityMap density = {};
};

/// Kinds of cases: "single", "none", "outside" (the catalogue) or "pair".
struct CaseTruth {
    std::string kind;
    std::vector<hidden::HiddenEffect> effects;
    std::vector<double> detectability = {};  ///< of each: `detectability` (detectability.hpp)
};

/// The vessel that a user believes in, meshed as `braidzone phantom` does.
Lumen believed_lumen(const Phantom& phantom);

/// The planned deployment of a belief.
Model believed_model(const hidden::Belief& belief);

/// Writes points as `x_mm,y_mm,z_mm` and end markers as `read_measured_scalars` reads them.
void write_scan(const hidden::ScannedDevice& scan, const fs::path& folder);

/// Writes the data of a case.
void write_case(const hidden::HiddenCase& made, const hidden::FurtherData& further,
                const fs::path& folder);

/// Reads them, density and force only if `with_further`. @throws what the readers of the files
/// throw
CaseData read_case(const fs::path& folder, bool with_further = false);

/// The truth as JSON. The salt keeps its digest from being guessed.
std::string truth_text(const CaseTruth& truth, std::uint64_t salt);

CaseTruth read_truth(const fs::path& file);

/// Names of the cases in a folder of data, in order.
std::vector<std::string> cases_in(const fs::path& data);

}  // namespace braidzone::blind

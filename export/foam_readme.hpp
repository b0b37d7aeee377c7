#pragma once

#include "export/foam_flow.hpp"
#include "export/foam_form.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// The folder's README.
std::string foam_readme(const FoamFlow& flow, const std::vector<FoamOpening>& openings,
                        FoamForm form);

}  // namespace braidzone

#pragma once

#include "export/foam_apply.hpp"
#include "export/foam_device.hpp"

#include <string>

namespace braidzone {

/// Text of fd_export.json: form, units, conventions, zones or baffles with their coefficients, the
/// integral over the sheet against that of what was written, and the error to expect from the
/// number of cells across the device (`thin_layer_error`).
std::string foam_report(const FoamApplication& result, const FoamDevice& device,
                        const CellResistance& resistance, const ResistanceSheet& sheet,
                        const FoamDepositOptions& deposit);

}  // namespace braidzone

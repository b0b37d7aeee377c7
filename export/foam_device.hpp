#pragma once

#include "export/foam_baffles.hpp"
#include "export/foam_cell_zones.hpp"
#include "export/foam_face_zones.hpp"
#include "export/foam_form.hpp"
#include "export/foam_per_cell.hpp"
#include "export/foam_porous_source.hpp"
#include "export/foam_zones.hpp"

#include <string>
#include <vector>

namespace braidzone {

/// The device in one of the forms, ready to be written into an OpenFOAM case.
struct FoamDevice {
    FoamForm form = FoamForm::zones;
    std::vector<FoamZone> zones;            ///< with `per_cell` of the quadratic part only
    std::vector<FoamDirectedField> fields;  ///< of `per_cell`
    std::vector<FoamBaffle> baffles;
    std::vector<FoamCellZone> cell_zones;
    std::vector<FoamFaceZone> face_zones;
    std::vector<FoamPorousSource> sources;
    std::string functions;           ///< that the fields need in controlDict
    double integral = 0.0;           ///< of the Darcy coefficient, of what is written [m]
    std::vector<std::string> notes;  ///< what the user must know of the form
};

struct FoamDeviceOptions {
    FoamForm form = FoamForm::zones;
    int most_zones = 64;          ///< zones or groups of baffles, see `cluster`
    bool shear_thinning = false;  ///< keep the sheet's viscosity, see `FoamPorousSource::viscosity`
};

/// @param resistance  the sheet's, as deposited on the mesh
/// @throws what `cluster` and `make_baffles` throw
FoamDevice make_foam_device(const ResistanceSheet& sheet, const CellResistance& resistance,
                            const FoamMesh& mesh, const FoamDeviceOptions& options = {});

}  // namespace braidzone

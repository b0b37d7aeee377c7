#pragma once

#include "core/vector.hpp"
#include "export/foam_form.hpp"

#include <string>

namespace braidzone {

/// What Allrun needs to know.
struct FoamRunPlan {
    std::string program;    ///< command or path of Braidzone; the variable BRAIDZONE wins over it
    std::string case_file;  ///< path of the case file, relative to the OpenFOAM case or absolute
    std::string solver = "simpleFoam";  ///< or "pimpleFoam"
    FoamForm form = FoamForm::zones;    ///< of the device
    Vec3 extent = Vec3::Ones();  ///< of the mesh [m]; parallel runs cut across its longest axes
};

/// The shell script that meshes, applies the device and solves, with or without it, on one process
/// or several, from the start or from where a run stopped, and prints the figures.
std::string allrun_script(const FoamRunPlan& plan);

/// The shell script that removes what Allrun made.
std::string allclean_script();

}  // namespace braidzone

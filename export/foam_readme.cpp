#include "export/foam_readme.hpp"

#include "export/foam_boundary_conditions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

namespace braidzone {

namespace {

constexpr const char* readme_head = R"md(# A treated vessel for OpenFOAM

    ./Allrun                    meshes, applies the flow diverter, solves
    ./Allrun --without-device   solves the same mesh without it, in without_device/
    ./Allrun --both             both, and prints what the device changes
    ./Allrun --both --processes 8
    ./Allrun --continue         goes on where a run was stopped (with --processes as it was)
    ./flow_figures              prints the figures again
    ./Allclean                  removes all that

It runs with OpenFOAM of openfoam.com, v1912 (Debian's package `openfoam`) or later. Braidzone
applies the device (`braidzone export CASE --onto .`); set BRAIDZONE to the program's path if it has
moved. OpenFOAM itself needs no plug-in and nothing compiled.

| file | holds |
|---|---|
| `constant/triSurface/vessel.stl` | the closed lumen [m]; solids wall, inlet, outlet_1, ... |
| `constant/triSurface/device.stl` | the part of the device that meets flow, for refinement |
| `constant/fdPorosity` | the resistance: Darcy-Forchheimer sources on cell zones |
| `constant/fvOptions`, `fvModels` | include it; the latter is openfoam.org's name |
| `constant/polyMesh/cellZones` | the zones; `sac`: the cells that the device closes off; further sacs are `sac_2`, ... |
| `constant/polyMesh/faceZones` | `sac_neck`: the faces between the sac and all other cells; `sac_wall`: its wall; `sac_2_neck`, ... |
| `0/fdDarcy`, `fdForchheimer`, `fdNormal`, `fdVoidFraction`, `fdSurfaceDensity`, `fdZone` | the device in the cells, to look at |
| `fd_export.json` | units, zones, and the sum over cells against the integral over the device |
| `flow_figures.csv` | the figures with and without the device, and the reductions |
| `postProcessing/neckFlow` | sum of \|flow rate\| over `sac_neck` [m^3/s]: twice the inflow |
| `postProcessing/sacSpeed` | mean speed in the sac [m/s] |
| `postProcessing/sacWallShear` | mean wall shear stress on `sac_wall` over the density [m^2/s^2] |
| `postProcessing/sac_2NeckFlow`, `sac_2Speed`, `sac_2WallShear`, ... | the same of further sacs |
| `postProcessing/inletPressure` | mean kinematic pressure at the inlet [m^2/s^2] |
| `postProcessing/inletFlow`, `outlet_1Flow`, ... | flow rates out of the vessel [m^3/s] |

Zones, fields and `fd_export.json` appear when the device is applied to the mesh.

The neck of the figures is `sac_neck`, on the sac's side of the layer of resistant cells, some three
cells from the braid itself: the same faces with and without the device. Inflow is half the sum of
|flow rate| over them, as what enters leaves again; two streams within one face cancel.

Lengths are in metres. p is the kinematic pressure p / rho [m^2/s^2]: times the density it is in Pa.
The source is S = -(mu D + 1/2 rho |U| F) U with D in 1/m^2 and F in 1/m along the axes of each zone.
D belongs to the viscosity in `constant/transportProperties`: export again if that changes.

## Flow
)md";

constexpr const char* rheology_text = R"md(
Blood is shear-thinning (Carreau-Yasuda; OpenFOAM's BirdCarreau). The device's resistance keeps the
Newtonian viscosity of the case file (porous model fixedCoeff in place of DarcyForchheimer): between
the wires the shear is high, and the resolved flow, whose viscosity a Darcy term would take, does not
know it.
)md";

constexpr const char* zones_text = R"md(
## The device
Cell zones FD_0000, ..., each with one resistance (`form = "zones"`), in `constant/fdPorosity`. It is
spread over six cells across. The thinner that layer, the nearer to the real one: repeat with one more
`device_refinement` to see what it changes.
)md";

constexpr const char* per_cell_text = R"md(
## The device
Each cell of the zone FD has its own resistance tensor (`form = "per_cell"`): sources along fixed
directions take `0/fdNuD_x`, ... in place of the viscosity. They hold nu D of the case file's
viscosity, whatever `constant/transportProperties` says. `system/fdFunctions` reads them at the start
and writes them with every time, so that a run can be continued. The quadratic part is in zones
FD_0000, ... OpenFOAM of openfoam.com only. What function objects call the porous force is wrong with
it: they multiply with the real viscosity.

The resistance is spread over six cells across; repeat with one more `device_refinement` to see what
that changes.
)md";

constexpr const char* baffles_text = R"md(
## The device
Pressure jumps on faces (`form = "baffles"`): the mesh has faces on the device, `createBaffles
-overwrite -dict system/fdBaffles` makes pairs of cyclic patches of them, FD_0000_front and
FD_0000_back, ..., with the condition porousBafflePressure. The mesh without them stays in
`constant/polyMesh.whole`, for the flow without the device too. No thickness, and no resistance along
the braid, whatever `tangential_ratio` says: flow slips along the device, and the sac moves faster than
with the other forms. `constant/fdPorosity` is empty.
)md";

std::string form_text(FoamForm form)
{
    switch (form) {
        case FoamForm::per_cell:
            return per_cell_text;
        case FoamForm::baffles:
            return baffles_text;
        case FoamForm::zones:
            break;
    }
    return zones_text;
}

constexpr const char* readme_tail = R"md(
## On a mesh of your own
`braidzone export CASE --onto FOLDER` applies the device to any OpenFOAM mesh of this vessel, in
metres and not decomposed. It writes the files named above and touches no others. To have neckFlow,
sacSpeed and sacWallShear, put `#includeIfPresent "fdFunctions"` into `functions` of
`system/controlDict`.
)md";

std::string openings_table(const std::vector<FoamOpening>& openings, const FoamFlow& flow)
{
    std::string text = "\n| patch | diameter [mm] | centre [mm] | condition |\n|---|---|---|---|\n";
    for (const FoamOpening& opening : openings) {
        const Vec3 centre = 1e3 * opening.centre;
        text += fmt::format("| {} | {:.4g} | {:.4g}, {:.4g}, {:.4g} | {} |\n", opening.name,
                            2e3 * std::sqrt(opening.area / std::numbers::pi), centre.x(),
                            centre.y(), centre.z(), opening_condition(opening, flow));
    }
    if (std::holds_alternative<MurraySplit>(flow.outlets))
        text += "\nShares are as the cubes of the outlets' radii (Murray 1926).\n";
    return text;
}

}  // namespace

std::string foam_readme(const FoamFlow& flow, const std::vector<FoamOpening>& openings,
                        FoamForm form)
{
    std::string text = readme_head;
    if (flow.waveform)
        text += fmt::format(
            "Laminar and pulsatile, in a rigid vessel: pimpleFoam over {} cycles of {:.6g} s, the "
            "inflow a table\nin `0/U` that repeats. The last cycle is kept, 20 times of it, and "
            "the "
            "figures are means over it.\n\nThe flow starts from the steady one at the table's "
            "first flow "
            "rate (`system.start/`): from rest, the sudden\nflow would stir the sac, and behind a "
            "device that dies down in about a second only. Look at\n`postProcessing/sacSpeed`, "
            "and raise `cycles` until one cycle is as the one before.\n",
            flow.cycles, period(*flow.waveform));
    else
        text += "Laminar and steady, in a rigid vessel: simpleFoam.\n";
    text += openings_table(openings, flow);
    if (flow.rheology) text += rheology_text;
    text += form_text(form);
    return text + readme_tail;
}

}  // namespace braidzone

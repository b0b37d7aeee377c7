#include "export/foam_scripts.hpp"

namespace braidzone {

namespace {

/// A word that the shell takes literally.
std::string quoted(const std::string& word)
{
    std::string text = "'";
    for (const char c : word) {
        if (c == '\'')
            text += "'\\''";
        else
            text += c;
    }
    return text + "'";
}

constexpr const char* allrun_head = R"sh(#!/bin/sh
# Meshes the lumen, applies the flow diverter's resistance and solves for steady flow.
#   ./Allrun                    with the device, in this folder
#   ./Allrun --without-device   the same mesh without it, in without_device/
# The mesh is made once; ./Allclean removes it.
set -eu
cd "$(dirname "$0")"

)sh";

constexpr const char* allrun_body = R"sh(
program="${BRAIDZONE:-$program}"
# Debian's package needs no environment script, only this.
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"

fail()
{
    echo "Allrun: $*" >&2
    exit 1
}

# run NAME COMMAND...: its output goes to log.NAME
run()
{
    name=$1
    shift
    echo "Allrun: $name"
    "$@" > "log.$name" 2>&1 || {
        tail -n 20 "log.$name" >&2
        fail "$name failed; see $PWD/log.$name"
    }
}

# solve FOLDER LOG: simpleFoam, from its start fields
solve()
{
    for time in "$1"/[1-9]*; do
        if [ -d "$time" ]; then rm -r "$time"; fi
    done
    rm -rf "$1/postProcessing"
    run "$2" simpleFoam -case "$1"
    grep "SIMPLE solution converged" "log.$2" || fail "simpleFoam did not converge; see $PWD/log.$2"
    speed="$1/postProcessing/sacSpeed/0/volFieldValue.dat"
    if [ -f "$speed" ]; then
        echo "mean speed in the sac [m/s]: $(tail -n 1 "$speed" | cut -f 2)"
    fi
}

variant=${1:-}
case "$variant" in
    "" | --without-device) ;;
    *) fail "unknown argument $variant; allowed: --without-device" ;;
esac
command -v simpleFoam > /dev/null ||
    fail "OpenFOAM's simpleFoam is not found (Debian: apt install openfoam)"
command -v "$program" > /dev/null ||
    fail "Braidzone is not found at '$program'; set BRAIDZONE to the program's path"

# snappyHexMesh writes cellLevel last.
if [ ! -f constant/polyMesh/cellLevel ]; then
    rm -rf constant/polyMesh
    run blockMesh blockMesh
    run surfaceFeatureExtract surfaceFeatureExtract
    run snappyHexMesh snappyHexMesh -overwrite
    run checkMesh checkMesh
    grep "Failed .* mesh checks" log.checkMesh || true
fi

# Without the device too: the zone of the sac, over which the speed is averaged, comes from here.
run braidzone "$program" export "$case_file" --onto .

if [ "$variant" = --without-device ]; then
    rm -rf without_device
    mkdir -p without_device/constant without_device/0
    ln -s ../system without_device/system
    for shared in polyMesh transportProperties turbulenceProperties; do
        ln -s "../../constant/$shared" "without_device/constant/$shared"
    done
    cp 0/U 0/p without_device/0/
    # system/fdFunctions reads these if the resistance is in them.
    for field in 0/fdNuD_*; do
        if [ -f "$field" ]; then cp "$field" without_device/0/; fi
    done
    solve without_device simpleFoam.without_device
else
    solve . simpleFoam
fi
)sh";

}  // namespace

std::string allrun_script(const std::string& program, const std::string& case_file)
{
    return allrun_head + ("program=" + quoted(program)) + "\ncase_file=" + quoted(case_file) +
           allrun_body;
}

std::string allclean_script()
{
    return R"sh(#!/bin/sh
# Removes the mesh, the solutions and the logs.
set -eu
cd "$(dirname "$0")"
for time in [1-9]*; do
    if [ -d "$time" ]; then rm -r "$time"; fi
done
rm -rf constant/polyMesh constant/extendedFeatureEdgeMesh constant/triSurface/vessel.eMesh
rm -rf without_device postProcessing log.* 0/fd* system/fdFunctions fd_export.json
)sh";
}

std::string foam_readme()
{
    return R"md(# A treated vessel for OpenFOAM

    ./Allrun                    meshes, applies the flow diverter, solves
    ./Allrun --without-device   solves the same mesh without it, in without_device/
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
| `constant/polyMesh/cellZones` | the zones; `sac`: the cells that the device closes off |
| `0/fdDarcy`, `fdForchheimer`, `fdNormal`, `fdVoidFraction`, `fdSurfaceDensity`, `fdZone` | the device in the cells, to look at |
| `fd_export.json` | units, zones, and the sum over cells against the integral over the device |
| `postProcessing/sacSpeed` | mean speed in the sac [m/s] at every iteration |
| `postProcessing/inletPressure` | mean kinematic pressure at the inlet [m^2/s^2] |

Zones, fields and `fd_export.json` appear when the device is applied to the mesh.

Lengths are in metres. p is the kinematic pressure p / rho [m^2/s^2]: times the density it is in Pa.
The source is S = -(mu D + 1/2 rho |U| F) U with D in 1/m^2 and F in 1/m along the axes of each zone.
D belongs to the viscosity in `constant/transportProperties`: export again if that changes.

Flow enters with a given flow rate and a flat profile and leaves against zero pressure. The wall is
rigid, the flow steady, laminar and Newtonian.

The device is spread over six cells across. The thinner that layer, the nearer to the real one: repeat
with one more `device_refinement` to see what it changes.

## On a mesh of your own
`braidzone export CASE --onto FOLDER` applies the device to any OpenFOAM mesh of this vessel, in
metres and not decomposed. It writes the files named above and touches no others. To have the speed
in the sac, put `#includeIfPresent "fdFunctions"` into `functions` of `system/controlDict`.
)md";
}

}  // namespace braidzone

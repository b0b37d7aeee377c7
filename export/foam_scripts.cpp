#include "export/foam_scripts.hpp"

#include <fmt/format.h>

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
# Meshes the lumen, applies the flow diverter's resistance, solves and prints the figures.
#   ./Allrun                    with the device, in this folder
#   ./Allrun --without-device   the same mesh without it, in without_device/
#   ./Allrun --both             one after the other, and what the device changes
#   --processes N               on N processes, by MPI (MPIRUN: the command, if not mpirun)
#   --continue                  goes on where a run was stopped
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

# time_folders FOLDER: the names of its time folders, in order
time_folders()
{
    ls "$1" | grep -E '^[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?$' | sort -g || true
}

# remove_solution FOLDER
remove_solution()
{
    for time in $(time_folders "$1"); do
        if [ "$time" != 0 ]; then rm -r "$1/$time"; fi
    done
    rm -rf "$1/postProcessing" "$1"/processor[0-9]*
}

# keep_before FOLDER: forgets what a stopped run reported after the fields that it wrote last
keep_before()
{
    solution=$1
    if [ -d "$1/processor0" ]; then
        stopped_on=$(ls -d "$1"/processor[0-9]* | wc -l)
        [ "$stopped_on" -eq "$processes" ] ||
            fail "the stopped run was on $((stopped_on)) processes; add --processes $((stopped_on))"
        solution="$1/processor0"
    fi
    latest=$(time_folders "$solution" | tail -n 1)
    rm -rf "$1"/postProcessing/*/"${latest:-0}"
}

write_decomposition()
{
    # Each prime factor, the largest first, cuts the axis along which the pieces are longest.
    cuts=$(echo "$processes $extent" | awk '{
        for (i = 1; i <= 3; i++) { length_of[i] = $(i + 1); cuts[i] = 1 }
        n = $1
        while (n > 1) {
            largest = n
            for (f = 2; f * f <= largest; )
                if (largest % f == 0 && largest > f) largest /= f; else f++
            axis = 1
            for (i = 2; i <= 3; i++) if (length_of[i] > length_of[axis]) axis = i
            cuts[axis] *= largest
            length_of[axis] /= largest
            n /= largest
        }
        print cuts[1], cuts[2], cuts[3]
    }')
    cat > system/decomposeParDict <<END
FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }
numberOfSubdomains $processes;
method hierarchical;
coeffs { n ($cuts); }
END
}

# start FOLDER SUFFIX: gives pulsatile flow the steady one at its first flow rate to start from
start()
{
    rm -rf "$1/start"
    mkdir "$1/start"
    ln -s ../constant "$1/start/constant"
    cp -r "$1/0" "$1/start/0"
    cp -r system.start "$1/start/system"
    if [ -f system/fdFunctions ]; then cp system/fdFunctions "$1/start/system/"; fi
    run "simpleFoam.start$2" simpleFoam -case "$1/start"
    cp -r "$1/start/$(time_folders "$1/start" | tail -n 1)" "$1/"
    rm -r "$1/start"
}

# solve FOLDER SUFFIX: from its start fields, or on from its last ones
solve()
{
    if [ "$continued" ]; then
        keep_before "$1"
    else
        remove_solution "$1"
        if [ "$solver" = pimpleFoam ]; then start "$1" "$2"; fi
    fi
    if [ "$processes" -eq 1 ]; then
        run "$solver$2" "$solver" -case "$1"
    else
        as_root=  # which mpirun refuses without being asked to
        if [ "$(id -u)" -eq 0 ]; then as_root=--allow-run-as-root; fi
        if [ ! -d "$1/processor0" ]; then run "decomposePar$2" decomposePar -case "$1"; fi
        run "$solver$2" ${MPIRUN:-mpirun} $as_root -np "$processes" "$solver" -case "$1" -parallel
        run "reconstructPar$2" reconstructPar -case "$1" -newTimes
        rm -r "$1"/processor[0-9]*
    fi
    if [ "$solver" = simpleFoam ]; then
        grep "SIMPLE solution converged" "log.$solver$2" ||
            fail "$solver did not converge; see $PWD/log.$solver$2"
    fi
}

with=yes
without=
continued=
processes=1
while [ $# -gt 0 ]; do
    case "$1" in
        --without-device) with= without=yes ;;
        --both) with=yes without=yes ;;
        --continue) continued=yes ;;
        --processes)
            processes=${2:-}
            case "$processes" in
                "" | 0* | *[!0-9]*) fail "--processes '$processes'; allowed: 1 or more" ;;
            esac
            shift
            ;;
        *) fail "unknown argument $1; allowed: --without-device, --both, --processes N, --continue" ;;
    esac
    shift
done
command -v "$solver" > /dev/null ||
    fail "OpenFOAM's $solver is not found (Debian: apt install openfoam)"
command -v "$program" > /dev/null ||
    fail "Braidzone is not found at '$program'; set BRAIDZONE to the program's path"

# snappyHexMesh writes cellLevel last.
if [ ! -f constant/polyMesh/cellLevel ]; then
    [ ! "$continued" ] || fail "--continue: there is no mesh, and no run that was stopped"
    rm -rf constant/polyMesh
    run blockMesh blockMesh
    run surfaceFeatureExtract surfaceFeatureExtract
    run snappyHexMesh snappyHexMesh -overwrite
    run checkMesh checkMesh
    grep "Failed .* mesh checks" log.checkMesh || true
fi

# Without the device too: the zones of the sac, for the figures, come from here. Baffles cut the
# mesh along the device; the whole mesh stays in constant/polyMesh.whole.
whole=constant/polyMesh
if [ "$form" = baffles ]; then whole=constant/polyMesh.whole; fi
if [ ! "$continued" ]; then
    if [ -d constant/polyMesh.whole ]; then
        rm -rf constant/polyMesh
        cp -r constant/polyMesh.whole constant/polyMesh
    fi
    run braidzone "$program" export "$case_file" --onto .
    if [ "$form" = baffles ]; then
        rm -rf constant/polyMesh.whole
        cp -r constant/polyMesh constant/polyMesh.whole
        run createBaffles createBaffles -overwrite -dict system/fdBaffles
    fi
fi

if [ "$processes" -gt 1 ]; then
    cells=$(sed -n 's/^  "num_cells": \([0-9]*\).*/\1/p' fd_export.json)
    most=$((cells / 1000))
    [ "$processes" -le "$most" ] ||
        fail "--processes $processes is too many for $cells cells; allowed: 1 to $most (1000 cells each)"
    write_decomposition
fi

if [ "$with" ]; then solve . ""; fi
if [ "$without" ]; then
    if [ ! "$continued" ] || [ ! -d without_device ]; then
        rm -rf without_device
        mkdir -p without_device/constant without_device/0
        ln -s ../system without_device/system
        ln -s "../../$whole" without_device/constant/polyMesh
        for shared in transportProperties turbulenceProperties; do
            ln -s "../../constant/$shared" "without_device/constant/$shared"
        done
        cp 0/U 0/p without_device/0/
        # system/fdFunctions reads these if the resistance is in them.
        for field in 0/fdNuD_*; do
            if [ -f "$field" ]; then cp "$field" without_device/0/; fi
        done
    fi
    solve without_device .without_device
fi
[ -f system/fdFunctions ] ||
    echo "Allrun: the device closes no sac off; there are no figures of one"
./flow_figures
)sh";

}  // namespace

std::string allrun_script(const FoamRunPlan& plan)
{
    return allrun_head + ("program=" + quoted(plan.program)) +
           "\ncase_file=" + quoted(plan.case_file) + "\nsolver=" + plan.solver +
           "\nform=" + traits_of(plan.form).name +
           fmt::format("\nextent='{} {} {}'  # m", plan.extent.x(), plan.extent.y(),
                       plan.extent.z()) +
           allrun_body;
}

std::string allclean_script()
{
    return R"sh(#!/bin/sh
# Removes the mesh, the solutions and the logs.
set -eu
cd "$(dirname "$0")"
for time in [1-9]* 0.[0-9]*; do
    if [ -d "$time" ]; then rm -r "$time"; fi
done
rm -rf processor[0-9]* system/decomposeParDict flow_figures.csv
rm -rf constant/polyMesh constant/polyMesh.whole constant/extendedFeatureEdgeMesh constant/triSurface/vessel.eMesh
rm -rf without_device postProcessing log.* 0/fd* system/fdFunctions system/fdBaffles fd_export.json
)sh";
}

}  // namespace braidzone

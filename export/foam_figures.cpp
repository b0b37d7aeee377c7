#include "export/foam_figures.hpp"

#include "export/foam_function.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace braidzone {

namespace {

std::string magnitude_function(const char* name, const char* field)
{
    return fmt::format(R"({}
{{
    type            mag;
    libs            ("libfieldFunctionObjects.so");
    field           {};
    writeControl    writeTime;
}}
)",
                       name, field);
}

constexpr const char* figures_body = R"sh(
# value FOLDER FUNCTION: at the last iteration, or the mean over the last cycle; nothing if the
# function has no file there, or the run did not reach the cycle's end. A continued run has a folder
# for each start; what is calculated again wins.
value()
{
    folder="$1/postProcessing/$2"
    [ -d "$folder" ] || return 0
    for start in $(ls "$folder" | sort -g); do
        cat "$folder/$start"/*.dat
    done | awk -v from="$cycle_start" -v to="$cycle_end" '
        /^#/ || NF < 2 { next }
        {
            while (n > 0 && t[n] >= $1) n--
            t[++n] = $1
            v[n] = $2
        }
        END {
            if (n == 0) exit
            if (from == "") { printf "%.9g", v[n]; exit }
            slack = 1e-6 * (to - from)
            if (t[n] < to - slack) exit
            for (i = 2; i <= n; i++) {
                if (t[i - 1] < from - slack) continue
                step = t[i] - t[i - 1]
                sum += 0.5 * (v[i] + v[i - 1]) * step
                span += step
            }
            if (span > 0) printf "%.9g", sum / span
        }'
}

row()
{
    awk -v name="$1" -v unit="$2" -v factor="$3" -v with="$4" -v without="$5" 'BEGIN {
        if (with != "") with = sprintf("%.6g", factor * with)
        if (without != "") without = sprintf("%.6g", factor * without)
        if (with != "" && without != "" && without + 0 != 0)
            reduction = sprintf("%.4g", 100 * (1 - with / without))
        printf "%s,%s,%s,%s,%s\n", name, unit, without, with, reduction
    }'
}

# percent PART WHOLE
percent()
{
    [ -n "$1" ] && [ -n "$2" ] || return 0
    awk -v part="$1" -v whole="$2" 'BEGIN {
        if (whole < 0) whole = -whole
        if (whole > 0) printf "%.9g", 50 * part / whole
    }'
}

# both NAME UNIT FACTOR FUNCTION
both() { row "$1" "$2" "$3" "$(value . "$4")" "$(value without_device "$4")"; }

# sac_rows ADDITION SPEED NECK_FLOW WALL_SHEAR
sac_rows()
{
    with_neck=$(value . "$3")
    without_neck=$(value without_device "$3")
    row "inflow through the neck$1" "mL/s" 0.5e6 "$with_neck" "$without_neck"
    row "inflow through the neck$1" "% of the parent flow" 1 \
        "$(percent "$with_neck" "$(value . inletFlow)")" \
        "$(percent "$without_neck" "$(value without_device inletFlow)")"
    both "mean speed in the sac$1" "mm/s" 1e3 "$2"
    both "mean wall shear stress in the sac$1" "Pa" "$density" "$4"
}

# has FUNCTION: it was calculated, with or without the device
has() { [ -d "postProcessing/$1" ] || [ -d "without_device/postProcessing/$1" ]; }

{
    echo "quantity,unit,without_device,with_device,reduction_percent"
    if has sacSpeed; then sac_rows "" sacSpeed neckFlow sacWallShear; fi
    number=2
    while has "sac_${number}Speed"; do
        sac_rows " $number" "sac_${number}Speed" "sac_${number}NeckFlow" "sac_${number}WallShear"
        number=$((number + 1))
    done
    if has outlet_2Flow; then
        number=1
        while has "outlet_${number}Flow"; do
            both "flow out of outlet_$number" "mL/s" 1e6 "outlet_${number}Flow"
            number=$((number + 1))
        done
    fi
} > flow_figures.csv

awk -F , '
    NR == 1 { printf "%-34s %-21s %12s %12s %12s\n", "", "", "without", "with device", "reduction" }
    NR > 1 {
        for (i = 3; i <= 5; i++) if ($i == "") $i = "-"
        printf "%-34s %-21s %12s %12s %12s\n", $1, $2, $3, $4, $5 == "-" ? "-" : $5 " %"
    }' flow_figures.csv
)sh";

}  // namespace

SacNames sac_names(std::size_t number)
{
    if (number == 0) return {"sac", "sac_neck", "sac_wall", "sacSpeed", "neckFlow", "sacWallShear"};
    const std::string sac = fmt::format("sac_{}", number + 1);
    return {sac, sac + "_neck", sac + "_wall", sac + "Speed", sac + "NeckFlow", sac + "WallShear"};
}

std::string figure_functions(const std::vector<SacFigures>& sacs)
{
    if (sacs.empty()) return "";
    std::string text = "// Mean speed in each sac [m/s]: postProcessing/sacSpeed/.\n" +
                       magnitude_function("speed", "U");
    for (const SacFigures& sac : sacs)
        text += value_function({sac.names.speed, "volFieldValue", "cellZone", sac.names.cells,
                                "volAverage", "mag(U)"});
    text +=
        "// Sum of |flow rate| over each neck, twice the inflow [m^3/s]: "
        "postProcessing/neckFlow/.\n";
    for (const SacFigures& sac : sacs) {
        if (sac.has_neck)
            text += value_function({sac.names.neck_flow, "surfaceFieldValue", "faceZone",
                                    sac.names.neck, "sumMag", "phi"});
    }
    const auto has_wall = [](const SacFigures& sac) { return sac.has_wall; };
    if (std::none_of(sacs.begin(), sacs.end(), has_wall)) return text;
    text +=
        "// Mean wall shear stress of each sac over rho [m^2/s^2]: "
        "postProcessing/sacWallShear/.\n"
        "wallShearStress\n{\n"
        "    type            wallShearStress;\n"
        "    libs            (\"libfieldFunctionObjects.so\");\n"
        "    writeControl    writeTime;\n"
        "    log             no;\n"
        "}\n" +
        magnitude_function("wallShear", "wallShearStress");
    for (const SacFigures& sac : sacs) {
        if (sac.has_wall)
            text += value_function({sac.names.wall_shear, "surfaceFieldValue", "faceZone",
                                    sac.names.wall, "areaAverage", "mag(wallShearStress)"});
    }
    return text;
}

std::string flow_figures_script(const FoamFlow& flow, double density)
{
    const std::string head =
        "#!/bin/sh\n"
        "# Prints what the device changes, from postProcessing/ here and in without_device/, and\n"
        "# writes it to flow_figures.csv. " +
        std::string(flow.waveform ? "Means over the last cycle.\n" : "At the last iteration.\n") +
        "set -eu\ncd \"$(dirname \"$0\")\"\n\n";
    std::string cycle = "cycle_start=\ncycle_end=\n";
    if (flow.waveform) {
        const double one = period(*flow.waveform);
        cycle = fmt::format("cycle_start={}\ncycle_end={}\n", (flow.cycles - 1) * one,
                            flow.cycles * one);
    }
    return head + fmt::format("density={}  # kg/m^3\n", density) + cycle + figures_body;
}

}  // namespace braidzone

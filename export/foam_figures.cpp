#include "export/foam_figures.hpp"

#include "export/foam_function.hpp"
#include "export/foam_neck.hpp"

#include <fmt/format.h>

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

with_neck=$(value . neckFlow)
without_neck=$(value without_device neckFlow)
{
    echo "quantity,unit,without_device,with_device,reduction_percent"
    row "inflow through the neck" "mL/s" 0.5e6 "$with_neck" "$without_neck"
    row "inflow through the neck" "% of the parent flow" 1 \
        "$(percent "$with_neck" "$(value . inletFlow)")" \
        "$(percent "$without_neck" "$(value without_device inletFlow)")"
    row "mean speed in the sac" "mm/s" 1e3 "$(value . sacSpeed)" "$(value without_device sacSpeed)"
    row "mean wall shear stress in the sac" "Pa" "$density" \
        "$(value . sacWallShear)" "$(value without_device sacWallShear)"
} > flow_figures.csv

awk -F , '
    NR == 1 { printf "%-34s %-21s %12s %12s %12s\n", "", "", "without", "with device", "reduction" }
    NR > 1 {
        for (i = 3; i <= 5; i++) if ($i == "") $i = "-"
        printf "%-34s %-21s %12s %12s %12s\n", $1, $2, $3, $4, $5 == "-" ? "-" : $5 " %"
    }' flow_figures.csv
)sh";

}  // namespace

std::string figure_functions(const SacFaces& faces)
{
    std::string text =
        "// Mean speed in the cell zone \"sac\" [m/s]: postProcessing/sacSpeed/.\n" +
        magnitude_function("speed", "U") +
        value_function({"sacSpeed", "volFieldValue", "cellZone", "sac", "volAverage", "mag(U)"});
    if (faces.neck)
        text +=
            "// Sum of |flow rate| over the neck, twice the inflow [m^3/s]: "
            "postProcessing/neckFlow/.\n" +
            value_function(
                {"neckFlow", "surfaceFieldValue", "faceZone", sac_neck_zone, "sumMag", "phi"});
    if (faces.wall)
        text +=
            "// Mean wall shear stress of the sac over rho [m^2/s^2]: "
            "postProcessing/sacWallShear/.\n"
            "wallShearStress\n{\n"
            "    type            wallShearStress;\n"
            "    libs            (\"libfieldFunctionObjects.so\");\n"
            "    writeControl    writeTime;\n"
            "    log             no;\n"
            "}\n" +
            magnitude_function("wallShear", "wallShearStress") +
            value_function({"sacWallShear", "surfaceFieldValue", "faceZone", sac_wall_zone,
                            "areaAverage", "mag(wallShearStress)"});
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

#include "export/foam_boundary_conditions.hpp"

#include "export/foam_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace braidzone {

namespace {

/// The entries of a flow rate over time: `share` of the inflow.
std::string flow_rate_entries(const FoamFlow& flow, double inlet_area, double share)
{
    if (!flow.waveform)
        return fmt::format("        volumetricFlowRate constant {};\n",
                           share * flow.inlet_velocity * inlet_area);
    // Not in a dictionary of its own: v1912 looks for these entries beside each other.
    std::string text =
        "        outOfBounds repeat;\n"
        "        volumetricFlowRate table  // [s] and [m^3/s]\n        (\n";
    for (std::size_t i = 0; i < flow.waveform->times.size(); ++i)
        fmt::format_to(std::back_inserter(text), "            ({} {})\n", flow.waveform->times[i],
                       share * flow.waveform->flow_rates[i]);
    return text + "        );\n";
}

}  // namespace

std::string velocity_field(const std::vector<FoamOpening>& openings, const FoamFlow& flow)
{
    const auto inlet = std::find_if(openings.begin(), openings.end(),
                                    [](const FoamOpening& opening) { return opening.is_inlet(); });
    std::string text = foam_header("volVectorField", "0", "U") +
                       "dimensions      [0 1 -1 0 0 0 0];\ninternalField   uniform (0 0 0);\n\n"
                       "boundaryField\n{\n    wall { type noSlip; }\n";
    for (const FoamOpening& opening : openings) {
        text += fmt::format("    {}\n    {{\n", opening.name);
        if (opening.is_inlet())
            text +=
                "        type flowRateInletVelocity;\n" + flow_rate_entries(flow, inlet->area, 1.0);
        else if (opening.share)
            text += "        type flowRateOutletVelocity;\n" +
                    flow_rate_entries(flow, inlet->area, *opening.share);
        else
            text += "        type inletOutlet;\n        inletValue uniform (0 0 0);\n";
        text += "        value uniform (0 0 0);\n    }\n";
    }
    return text + "}\n";
}

std::string pressure_field(const std::vector<FoamOpening>& openings, double density)
{
    std::string text = foam_header("volScalarField", "0", "p") +
                       "dimensions      [0 2 -2 0 0 0 0];\ninternalField   uniform 0;\n\n"
                       "boundaryField\n{\n    wall { type zeroGradient; }\n";
    for (const FoamOpening& opening : openings)
        text += opening.is_inlet() || opening.share
                    ? fmt::format("    {} {{ type zeroGradient; }}\n", opening.name)
                    : fmt::format("    {} {{ type fixedValue; value uniform {}; }}\n", opening.name,
                                  opening.pressure / density);
    return text + "}\n";
}

std::string opening_condition(const FoamOpening& opening, const FoamFlow& flow)
{
    if (opening.is_inlet())
        return fmt::format("{} {:.4g} mL/s in, flat profile",
                           flow.waveform ? "pulsatile inflow, mean" : "inflow,",
                           1e6 * mean_inflow(flow, opening.area));
    if (opening.share) return fmt::format("{:.4g} % of the inflow leaves", 100.0 * *opening.share);
    return fmt::format("pressure {:.4g} Pa", opening.pressure);
}

}  // namespace braidzone

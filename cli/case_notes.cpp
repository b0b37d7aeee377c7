#include "cli/case_notes.hpp"

#include "core/place_text.hpp"
#include "deploy/deployment_measures.hpp"
#include "porous/range_check.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

namespace braidzone {
namespace {

/// Mean inscribed diameter along the centerline [m].
double mean_diameter(const Centerline& centerline)
{
    double sum = 0.0;
    for (const CrossSection& section : centerline.sections)
        sum += 2.0 * section.inscribed_radius;
    return sum / static_cast<double>(centerline.sections.size());
}

/// Viscosities under their keys, those of shear-thinning blood too.
std::vector<std::pair<const char*, double>> viscosities(const Case& job)
{
    std::vector<std::pair<const char*, double>> all = {{"fluid.viscosity", job.fluid.viscosity}};
    if (job.rheology) {
        all.emplace_back("fluid.zero_shear_viscosity", job.rheology->zero_shear_viscosity);
        all.emplace_back("fluid.infinite_shear_viscosity", job.rheology->infinite_shear_viscosity);
    }
    return all;
}

}  // namespace

std::vector<std::string> unit_slip_notes(const Case& job, const Centerline& centerline)
{
    std::vector<std::string> notes;
    for (const auto& [key, viscosity] : viscosities(job)) {
        if (viscosity > 0.1)
            notes.push_back(
                fmt::format("{} = {:.6g} Pa s is more than 0.1 Pa s; blood has 0.0035: is it in "
                            "mPa s?",
                            key, viscosity));
    }
    if (job.fluid.density < 500.0)
        notes.push_back(
            fmt::format("fluid.density = {:.6g} kg/m^3 is less than 500 kg/m^3; blood has 1056: is "
                        "it in g/cm^3?",
                        job.fluid.density));
    if (job.exports.openfoam && !job.exports.openfoam->flow.waveform &&
        job.exports.openfoam->flow.inlet_velocity > 5.0)
        notes.push_back(
            fmt::format("export.inlet_velocity = {:.6g} m/s is more than 5 m/s, faster than in any "
                        "artery: is it in cm/s?",
                        job.exports.openfoam->flow.inlet_velocity));
    if (const double diameter = mean_diameter(centerline); job.deposit.spacing > 0.1 * diameter)
        notes.push_back(
            fmt::format("grid.spacing = {:.6g} mm is more than a tenth of the vessel's mean "
                        "diameter of {:.6g} mm: voxels do not resolve the lumen",
                        1e3 * job.deposit.spacing, 1e3 * diameter));
    if (job.sheet.tangential_ratio < 1.0)
        notes.push_back(
            fmt::format("porous.tangential_ratio = {:.6g} is less than 1; wires are no-slip along "
                        "the sheet and resist there at least as much as across it",
                        job.sheet.tangential_ratio));
    return notes;
}

std::vector<std::string> outside_notes(const PlacedDevice& placed, const WallTree& wall)
{
    const int num_outside =
        measure(placed.deployment, placed.device, wall, wall_gap(placed.device), placed.openings)
            .nodes_outside_vessel;
    if (num_outside == 0) return {};
    return {fmt::format("{} of {} nodes lie outside the vessel: the deployment means nothing there",
                        num_outside, placed.deployment.nodes.size())};
}

std::vector<std::string> inversion_notes(const Deployment& deployment, const LengthUnit& unit)
{
    const std::vector<int> inverted = inverted_rhombi(deployment);
    if (inverted.empty()) return {};
    const int ring = inverted.front() / deployment.lattice.nodes_per_ring;
    const int column = inverted.front() % deployment.lattice.nodes_per_ring;
    Vec3 centre = Vec3::Zero();
    for (const int corner : rhombus_corners(deployment.lattice, ring, column))
        centre += 0.25 * deployment.nodes[static_cast<std::size_t>(corner)];
    return {fmt::format(
        "{} rhombi are turned over, the first at {:.4g} mm along the centerline, {}: the braid "
        "folds there, and its coverage and resistance there mean nothing",
        inverted.size(), 1e3 * deployment.ring_arc_length[static_cast<std::size_t>(ring)],
        place_text(centre, unit))};
}

std::vector<std::string> jam_notes(const ResistanceLaw& law, const ResistanceSheet& sheet,
                                   const Deployment& deployment,
                                   const std::vector<WallOpening>& openings, const LengthUnit& unit)
{
    if (std::holds_alternative<ConstantLaw>(law)) return {};
    const std::vector<Rhombus>& rhombi = sheet.surface.rhombi;
    const std::vector<NeckPart> parts = neck_parts(deployment, openings);
    std::size_t num_jammed = 0, num_at_neck = 0, first = 0;
    for (std::size_t i = 0; i < rhombi.size(); ++i) {
        if (!is_jammed(rhombi[i])) continue;
        if (num_jammed == 0) first = i;
        ++num_jammed;
        num_at_neck += parts[i] != NeckPart::none;
    }
    if (num_jammed == 0) return {};
    const auto ring = first / static_cast<std::size_t>(deployment.lattice.nodes_per_ring);
    return {fmt::format(
        "{} of {} rhombi are jammed ({} of them at the neck), the first at {:.4g} mm along the "
        "centerline, {}: wires of a family touch there (solidity above {}), no law holds, and the "
        "loss is that of {} at this solidity",
        num_jammed, rhombi.size(), num_at_neck, 1e3 * deployment.ring_arc_length[ring],
        place_text(sheet.surface.centres[first], unit), jammed_solidity, law_name(law))};
}

std::vector<std::string> chain_notes(const Case& job, const Chain& chain)
{
    std::vector<std::string> all = unit_slip_notes(job, chain.centerline);
    const LengthUnit& unit = job.vessel.unit;
    const auto add = [&](const std::vector<std::string>& notes, const char* whose) {
        for (const std::string& note : notes)
            all.push_back(whose + note);
    };
    const auto add_device = [&](const PlacedDevice& placed, const ResistanceSheet& sheet,
                                const char* whose) {
        add(apposition_notes(placed, chain.wall, unit), whose);
        add(outside_notes(placed, chain.wall), whose);
        add(inversion_notes(placed.deployment, unit), whose);
        add(jam_notes(job.law, sheet, placed.deployment, placed.openings, unit), whose);
    };
    add_device({job.device, job.schedule, chain.deployment, chain.openings}, chain.sheet, "");
    if (chain.second) {
        add_device({job.second_device->device, job.second_device->schedule,
                    chain.second->deployment, chain.second->openings},
                   chain.second->sheet, "second device: ");
    }
    add(range_warnings(job.law, chain.resistance.surface.rhombi, job.fluid), "");
    return all;
}

}  // namespace braidzone

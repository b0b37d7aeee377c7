#include "cli/case_geometry.hpp"
#include "cli/case_notes.hpp"
#include "cli/commands.hpp"
#include "core/rounded_ends.hpp"
#include "core/triangle_mesh.hpp"
#include "deploy/opening_kind.hpp"
#include "export/foam_boundary_conditions.hpp"
#include "export/foam_fluid.hpp"
#include "export/lattice_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

/// Ends that are closed: blind branches and sacs, which vessel.openings can cut open.
void print_closed_ends(const Vessel& vessel)
{
    std::size_t number = vessel.openings.size();
    for (const RoundedEnd& end : rounded_ends(vessel.wall, vessel.openings, WallTree(vessel))) {
        const Vec3 place = 1e3 * end.centre;
        fmt::print("  {}: closed end about {:.2f} mm wide at ({:.2f}, {:.2f}, {:.2f}) mm\n",
                   number++, 2e3 * end.radius, place.x(), place.y(), place.z());
    }
}

void print_vessel(const Case& job, const Vessel& vessel)
{
    const Vec3 size = bounding_box(vessel.wall).upper - bounding_box(vessel.wall).lower;
    fmt::print("vessel      {}\n", job.vessel.surface.string());
    fmt::print("  {} triangles, {:.4g} x {:.4g} x {:.4g} mm, {} openings\n",
               vessel.wall.triangles.size(), 1e3 * size.x(), 1e3 * size.y(), 1e3 * size.z(),
               vessel.openings.size());
    fmt::print("{}\n", describe_openings(vessel));
    print_closed_ends(vessel);
    for (const std::string& note : vessel.notes)
        fmt::print("  note: {}\n", note);
}

void print_centerline(const Case& job, const Centerline& centerline, const Vessel& vessel)
{
    const auto [thinnest, widest] =
        std::minmax_element(centerline.sections.begin(), centerline.sections.end(),
                            [](const CrossSection& first, const CrossSection& second) {
                                return first.inscribed_radius < second.inscribed_radius;
                            });
    fmt::print("centerline  {}\n",
               job.vessel.centerline ? job.vessel.centerline->string() : "computed");
    fmt::print(
        "  {:.4g} mm long, from opening {} to opening {}; inscribed diameter {:.4g} to {:.4g} "
        "mm\n",
        1e3 * centerline.length(), nearest_opening(vessel, centerline.sections.front().origin),
        nearest_opening(vessel, centerline.sections.back().origin),
        2e3 * thinnest->inscribed_radius, 2e3 * widest->inscribed_radius);
}

void print_device(const char* label, const FlowDiverter& device,
                  const std::vector<std::string>& notes)
{
    fmt::print("{:<11} {} {:.4g} x {:.4g} mm\n", label, device.name, 1e3 * device.nominal_diameter,
               1e3 * device.nominal_length);
    fmt::print("  {} wires of {:.4g} um, braid ratio {:.4g}, catheter {:.4g} mm\n",
               device.num_wires, 1e6 * device.wire_diameter, device.braid_ratio,
               1e3 * device.catheter_diameter);
    fmt::print("  forces from {}\n", force_origin(device));
    for (const std::string& note : notes)
        fmt::print("  note: {}\n", note);
}

std::string spacing_text(double sliding)
{
    if (sliding == 0.0) return "nominal spacing";
    if (sliding == 1.0) return "force-free spacing";
    return fmt::format("{:.4g} of the way from nominal to force-free spacing", sliding);
}

void print_release(const ReleaseSchedule& schedule)
{
    if (!schedule.table_file.empty()) {
        fmt::print("  released at the spacing of {}\n", schedule.table_file.string());
    } else {
        fmt::print("  released at {}\n", spacing_text(schedule.sliding));
    }
    for (const PushPull& window : schedule.windows) {
        fmt::print("  {} from {:.4g} to {:.4g} mm, to {:.4g} of that spacing\n",
                   window.spacing < 1.0 ? "pushed" : "pulled", 1e3 * window.from, 1e3 * window.to,
                   window.spacing);
    }
    for (const AxialTwist& twist : schedule.twists) {
        fmt::print("  twisted by {:.4g} deg from {:.4g} to {:.4g} mm\n",
                   twist.angle * 180.0 / std::numbers::pi, 1e3 * (twist.centre - twist.half_width),
                   1e3 * (twist.centre + twist.half_width));
    }
    for (const IncompleteOpening& opening : schedule.incomplete_openings) {
        fmt::print("  {} {:.4g} mm not fully open, by {:.4g} of the radius at the end{}\n",
                   name_of(opening.end), 1e3 * opening.length, opening.shrink,
                   opening.lean > 0.0
                       ? fmt::format(", leaning by {:.4g} towards {:.4g} deg", opening.lean,
                                     opening.lean_angle * 180.0 / std::numbers::pi)
                       : "");
    }
}

void print_landing(const Deployment& deployment, const ReleaseSchedule& schedule)
{
    const auto& places = deployment.ring_arc_length;
    double narrowest = deployment.rings.front().inscribed_radius, widest = narrowest;
    for (const CrossSection& ring : deployment.rings) {
        narrowest = std::min(narrowest, ring.inscribed_radius);
        widest = std::max(widest, ring.inscribed_radius);
    }
    fmt::print(
        "landing     {:.4g} to {:.4g} mm along the centerline, where the vessel is {:.4g} to "
        "{:.4g} mm wide\n",
        1e3 * places.back(), 1e3 * places.front(), 2e3 * narrowest, 2e3 * widest);
    print_release(schedule);
}

void print_openings(const Deployment& deployment, const std::vector<WallOpening>& openings)
{
    if (openings.empty()) {
        fmt::print("neck        none: the vessel does not open behind the device\n");
        return;
    }
    for (const WallOpening& opening : openings) {
        const auto place = [&](int ring) {
            return 1e3 * deployment.ring_arc_length[static_cast<std::size_t>(ring)];
        };
        fmt::print(
            "{:<11} {:.4g} to {:.4g} mm along the centerline, {:.4g} mm2 of the device{}\n",
            &opening == neck_of(openings) ? "neck" : name_of(opening.kind),
            place(opening.proximal_ring), place(opening.distal_ring), 1e6 * opening.area,
            opening.vessel_openings.empty()
                ? ""
                : fmt::format("; leads to opening {}", fmt::join(opening.vessel_openings, ", ")));
    }
}

void print_resistance(const Case& job)
{
    const bool whole = job.sheet.region == ResistanceRegion::whole_device;
    fmt::print("resistance  {}, {}; tangential ratio {:.4g}{}\n", law_name(job.law),
               whole ? "of the whole device" : "where the device is free of the wall",
               job.sheet.tangential_ratio,
               job.sheet.quadratic == QuadraticDrag::normal_only
                   ? ", quadratic part along the normal only"
                   : "");
    if (const auto* measured = std::get_if<MeasuredLaw>(&job.law)) {
        for (const MeasuredBraid& braid : measured->braids) {
            fmt::print(
                "  coverage {:.4g}, spacing {:.4g} um: a = {:.4g} Pa s/m, b = {:.4g} kg/m3, within "
                "{:.2g} % of what was measured\n",
                braid.metal_coverage, 1e6 * braid.wire_spacing, braid.loss.linear,
                braid.loss.quadratic, 100.0 * braid.fit_error);
        }
    }
}

void print_notes(const std::vector<std::string>& notes)
{
    for (const std::string& note : notes)
        fmt::print("  note: {}\n", note);
}

/// The flow of the OpenFOAM case, opening by opening.
void print_flow(const FoamFlow& flow, const Chain& chain)
{
    const char* label = "openfoam";
    int index = 0;
    for (const FoamOpening& opening : foam_openings(chain.vessel, inlet_of(chain), flow.outlets)) {
        fmt::print("{:<11} {}, opening {}: {}\n", label, opening.name, index++,
                   opening_condition(opening, flow));
        label = "";
    }
    if (flow.waveform) fmt::print("  {} cycles of {:.6g} s\n", flow.cycles, period(*flow.waveform));
}

void print_lattice(const Case& job, const Vessel& vessel, int inlet)
{
    const LatticeExportOptions& options = *job.exports.lattice;
    const double spacing = job.deposit.spacing;
    const ExtendedVessel extended = extend_openings(
        vessel,
        {.faces = options.openings, .inlet = inlet, .clearance = extension_clearance(spacing)});
    const LatticeCost cost = lattice_cost(extended.vessel, spacing, options.targets);
    require_room(cost, room_at(job.file.parent_path()));
    fmt::print("lattice     {}\n", describe(cost));
    for (const std::string& note : describe(extended.tubes, vessel))
        fmt::print("  note: {}\n", note);
}

/// Voxels of the box around the device; the field's own grid has a small margin.
double expected_voxels(const Deployment& deployment, double spacing)
{
    Vec3 lower = deployment.nodes.front(), upper = lower;
    for (const Vec3& node : deployment.nodes) {
        lower = lower.cwiseMin(node);
        upper = upper.cwiseMax(node);
    }
    return ((upper - lower) / spacing).array().ceil().prod();
}

}  // namespace

void check_case(const std::filesystem::path& case_file, const CommonOptions& options)
{
    const Case job = read_case(case_file, options.overrides);
    Progress progress(options.quiet);
    const Chain chain = run_chain(job, Stage::check, progress);
    if (options.quiet) return;

    print_vessel(job, chain.vessel);
    print_centerline(job, chain.centerline, chain.vessel);
    print_notes(chain.centerline_notes);
    print_device("device", job.device, job.device_notes);
    print_landing(chain.deployment, job.schedule);
    print_openings(chain.deployment, chain.openings);
    if (chain.second) {
        print_device("second", job.second_device->device, job.second_device->notes);
        print_landing(chain.second->deployment, job.second_device->schedule);
        print_openings(chain.second->deployment, chain.second->openings);
    }
    print_resistance(job);
    print_notes(chain_notes(job, chain));
    if (job.exports.openfoam) print_flow(job.exports.openfoam->flow, chain);
    if (job.rheology) fmt::print("  note: {}\n", rheology_note(job.fluid));
    const BraidLattice& lattice = chain.deployment.lattice;
    fmt::print(
        "cost        {} rings of {} nodes, {} steps in {:.2g} s; about {:.2g} million voxels of "
        "{:.4g} mm\n",
        lattice.num_rings, lattice.nodes_per_ring, chain.deployment.steps,
        progress.seconds("deploy"), 1e-6 * expected_voxels(chain.deployment, job.deposit.spacing),
        1e3 * job.deposit.spacing);
    if (job.exports.lattice) print_lattice(job, chain.vessel, inlet_of(chain));
}

}  // namespace braidzone

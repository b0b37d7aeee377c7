#include "cli/result_files.hpp"

#include "cli/case_geometry.hpp"
#include "cli/case_hash.hpp"
#include "cli/resolved_case.hpp"
#include "core/error.hpp"
#include "export/device_vtp.hpp"
#include "export/field_vdb.hpp"
#include "export/field_vti.hpp"
#include "export/foam_case.hpp"
#include "export/foam_fluid.hpp"
#include "export/frames_vtp.hpp"
#include "export/lattice_export.hpp"
#include "export/paraview_view.hpp"
#include "export/unrolled.hpp"
#include "export/vessel_vtp.hpp"
#include "export/wires_vtp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

void copy_to(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::copy_file(from, to, error);
    if (error) {
        throw IoError(fmt::format("{} cannot be copied to {}: {}", from.string(), to.string(),
                                  error.message()));
    }
}

/// Copies the case with its input files into a folder, as `case.toml`.
void write_case_copy(const Case& job, const fs::path& folder)
{
    fs::create_directories(folder);
    Case copy = job;
    copy.vessel.surface = "vessel" + job.vessel.surface.extension().string();
    copy_to(job.vessel.surface, folder / copy.vessel.surface);
    if (job.vessel.centerline) {
        copy.vessel.centerline = "centerline" + job.vessel.centerline->extension().string();
        copy_to(*job.vessel.centerline, folder / *copy.vessel.centerline);
    }
    if (auto* measured = std::get_if<MeasuredLaw>(&copy.law)) {
        const fs::path original = std::exchange(measured->table, "pressure_loss.csv");
        copy_to(original, folder / measured->table);
    }
    const auto copy_table = [&](ReleaseSchedule& schedule, const char* name) {
        if (schedule.table_file.empty()) return;
        copy_to(schedule.table_file, folder / name);
        schedule.table_file = name;
    };
    copy_table(copy.schedule, "spacing.csv");
    if (copy.second_device) copy_table(copy.second_device->schedule, "second_spacing.csv");
    if (copy.exports.openfoam && copy.exports.openfoam->flow.waveform) {
        const fs::path original =
            std::exchange(copy.exports.openfoam->flow.waveform->file, "flow.csv");
        copy_to(original, folder / "flow.csv");
    }
    const fs::path file = folder / "case.toml";
    std::ofstream text(file);
    text << "# The case that this folder was made from, with every value explicit.\n"
         << resolved_case_text(copy);
    if (!text.flush()) throw IoError(fmt::format("{} cannot be written", file.string()));
}

/// Writes the largest force on a free node on the way to rest.
void write_residuals(const fs::path& path, const Deployment& deployment)
{
    std::ofstream text(path);
    text << "step,max_force_residual_N\n";
    for (const ResidualSample& sample : deployment.residual_history)
        text << fmt::format("{},{:.6g}\n", sample.step, sample.residual);
    if (!text.flush()) throw IoError(fmt::format("{} cannot be written", path.string()));
}

/// The files of one device; their names begin with a prefix.
void write_device_files(const fs::path& folder, const std::string& prefix,
                        const Deployment& deployment, const ResistanceSheet& sheet,
                        double wire_diameter, const LengthUnit& unit)
{
    const auto path = [&](const char* name) { return folder / (prefix + name); };
    write_device(path("device.vtp"), deployment, sheet, unit);
    write_wires(path("wires.vtp"), deployment, wire_diameter, unit);
    write_unrolled(path("unrolled.vtp"), deployment, sheet, unit);
    write_unrolled_picture(path("unrolled.png"), deployment, sheet);
    write_residuals(path("residuals.csv"), deployment);
    if (deployment.frames.empty()) return;
    write_frames(path("frames.pvd"), deployment.lattice, deployment.frames, unit);
}

/// Returns what the user should know about the export.
std::vector<std::string> write_foam(const Case& job, const Chain& chain, const fs::path& folder)
{
    FoamCaseOptions options = *job.exports.openfoam;
    options.inlet = inlet_of(chain);
    options.flow.rheology = job.rheology;
    options.program = fs::read_symlink("/proc/self/exe").string();
    options.case_file = "braidzone/case.toml";
    write_foam_case(folder, chain.vessel, chain.resistance, job.fluid, options);
    write_case_copy(job, folder / "braidzone");
    if (!job.rheology) return {};
    return {rheology_note(job.fluid)};
}

std::vector<std::string> write_lattice_of(const Case& job, const Chain& chain,
                                          const fs::path& folder)
{
    LatticeExportOptions options = *job.exports.lattice;
    options.inlet = inlet_of(chain);
    options.necks = neck_probes(chain.deployment, chain.openings);
    std::vector<std::string> notes =
        export_lattice(folder, *chain.field, chain.vessel, job.fluid, options);
    if (job.rheology) {
        notes.push_back(
            "lattice/ is for a Newtonian fluid of fluid.viscosity; fluid.rheology is for OpenFOAM "
            "only");
    }
    return notes;
}

std::vector<std::string> write_surfaces_of(const Case& job, const Chain& chain,
                                           const fs::path& folder, const FileOrigin& origin)
{
    std::vector<SurfaceDevice> devices{{"", chain.deployment, job.device.wire_diameter}};
    if (chain.second) {
        devices.push_back(
            {"second_", chain.second->deployment, job.second_device->device.wire_diameter});
    }
    return write_surfaces(folder, chain.vessel, chain.wall, devices, *job.exports.surfaces, origin);
}

/// Across the device in its middle, the neck upwards; without one, the side that the middle ring's
/// frame names.
StandardView standard_view(const Chain& chain)
{
    const Deployment& deployment = chain.deployment;
    const CrossSection& middle = deployment.rings[deployment.rings.size() / 2];
    const Vec3 chord = deployment.rings.front().origin - deployment.rings.back().origin;
    StandardView view;
    view.centre = middle.origin;
    view.along = chord.norm() > 0.0 ? Vec3(chord.normalized()) : middle.tangent;
    view.towards = middle.normal;
    view.size = 1.2 * chord.norm();
    view.has_field = chain.field.has_value();
    view.has_second = chain.second.has_value();
    if (chain.openings.empty() || chain.openings.front().nodes.empty()) return view;
    Vec3 neck = Vec3::Zero();
    for (const int node : chain.openings.front().nodes)
        neck += deployment.nodes[static_cast<std::size_t>(node)];
    neck /= static_cast<double>(chain.openings.front().nodes.size());
    const std::size_t ring = static_cast<std::size_t>(chain.openings.front().distal_ring +
                                                      chain.openings.front().proximal_ring) /
                             2;
    view.centre = deployment.rings[ring].origin;
    view.towards = neck - view.centre;
    view.along = deployment.rings[ring].tangent;
    return view;
}

}  // namespace

std::vector<std::string> write_results(const Case& job, const Chain& chain, Stage last,
                                       const fs::path& folder)
{
    const LengthUnit& unit = chain.vessel.unit;
    const FileOrigin origin{"Braidzone " BRAIDZONE_VERSION, case_hash(job)};
    write_vessel_vtp(folder / "vessel.vtp", chain.vessel);
    write_device_files(folder, "", chain.deployment, chain.sheet, job.device.wire_diameter, unit);
    if (chain.second) {
        write_device_files(folder, "second_", chain.second->deployment, chain.second->sheet,
                           job.second_device->device.wire_diameter, unit);
    }
    if (chain.field) {
        write_field_vdb(folder / "field.vdb", *chain.field, unit, origin);
        write_field_vti(folder / "field.vti", *chain.field, unit);
    }
    write_paraview_view(folder / "view.py", standard_view(chain), unit);
    if (last != Stage::exports) return {};
    std::vector<std::string> notes;
    const auto add_notes = [&](const std::vector<std::string>& more) {
        notes.insert(notes.end(), more.begin(), more.end());
    };
    if (job.exports.openfoam) add_notes(write_foam(job, chain, folder / "openfoam"));
    if (job.exports.lattice) add_notes(write_lattice_of(job, chain, folder / "lattice"));
    if (job.exports.surfaces) add_notes(write_surfaces_of(job, chain, folder / "surfaces", origin));
    return notes;
}

std::vector<std::string> files_in(const fs::path& folder)
{
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), folder).string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace braidzone

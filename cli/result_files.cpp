#include "cli/result_files.hpp"

#include "cli/case_geometry.hpp"
#include "cli/resolved_case.hpp"
#include "core/error.hpp"
#include "export/device_vtp.hpp"
#include "export/field_vdb.hpp"
#include "export/field_vti.hpp"
#include "export/foam_case.hpp"
#include "export/frames_vtp.hpp"
#include "export/lattice_export.hpp"
#include "export/unrolled.hpp"
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

void write_foam(const Case& job, const Chain& chain, const fs::path& folder)
{
    FoamCaseOptions options = *job.exports.openfoam;
    options.inlet = inlet_of(chain);
    options.program = fs::read_symlink("/proc/self/exe").string();
    options.case_file = "braidzone/case.toml";
    write_foam_case(folder, chain.vessel, chain.resistance, job.fluid, options);
    write_case_copy(job, folder / "braidzone");
}

std::vector<std::string> write_lattice_of(const Case& job, const Chain& chain,
                                          const fs::path& folder)
{
    LatticeExportOptions options = *job.exports.lattice;
    options.inlet = inlet_of(chain);
    options.necks = neck_probes(chain.deployment, chain.openings);
    return export_lattice(folder, *chain.field, chain.vessel, job.fluid, options);
}

}  // namespace

std::vector<std::string> write_results(const Case& job, const Chain& chain, Stage last,
                                       const fs::path& folder)
{
    const LengthUnit& unit = chain.vessel.unit;
    write_device_files(folder, "", chain.deployment, chain.sheet, job.device.wire_diameter, unit);
    if (chain.second) {
        write_device_files(folder, "second_", chain.second->deployment, chain.second->sheet,
                           job.second_device->device.wire_diameter, unit);
    }
    if (chain.field) {
        write_field_vdb(folder / "field.vdb", *chain.field, unit);
        write_field_vti(folder / "field.vti", *chain.field, unit);
    }
    if (last != Stage::exports) return {};
    if (job.exports.openfoam) write_foam(job, chain, folder / "openfoam");
    if (!job.exports.lattice) return {};
    return write_lattice_of(job, chain, folder / "lattice");
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

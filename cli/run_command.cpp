#include "cli/case_hash.hpp"
#include "cli/commands.hpp"
#include "cli/law_report.hpp"
#include "cli/output_folder.hpp"
#include "cli/result_files.hpp"
#include "cli/summary.hpp"
#include "core/error.hpp"
#include "export/foam_apply.hpp"
#include "export/foam_fluid.hpp"
#include "export/law_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>

namespace braidzone {
namespace {

std::filesystem::path default_output(const std::filesystem::path& case_file)
{
    return std::filesystem::path(case_file).replace_extension(".out");
}

void write_summary(const std::filesystem::path& path, const nlohmann::ordered_json& summary)
{
    std::ofstream file(path);
    file << summary.dump(2) << '\n';
    if (!file.flush()) throw IoError(fmt::format("{} cannot be written", path.string()));
}

std::string title(const Case& job)
{
    return fmt::format("{} {:.4g} x {:.4g} mm in {}", job.device.name,
                       1e3 * job.device.nominal_diameter, 1e3 * job.device.nominal_length,
                       job.vessel.surface.filename().string());
}

/// The mesh and the deployment should tell of as many sacs. They do not where the device leaves the
/// wall at an end, a mesh is too coarse for the gap between a neck and an ostium, or a sac shares
/// its pouch with a branch.
std::optional<std::string> sac_count_warning(const Chain& chain, const FoamApplication& applied)
{
    const auto is_sac = [](const WallOpening& opening) {
        return opening.kind == OpeningKind::sac && !opening.nodes.empty();
    };
    auto num_sacs = std::count_if(chain.openings.begin(), chain.openings.end(), is_sac);
    if (chain.second)
        num_sacs = std::max(num_sacs, std::count_if(chain.second->openings.begin(),
                                                    chain.second->openings.end(), is_sac));
    if (static_cast<std::size_t>(num_sacs) == applied.sac_volumes.size()) return std::nullopt;
    return fmt::format(
        "{} sacs lie behind the device and the mesh has {} that it closes off: their figures are "
        "of those",
        num_sacs, applied.sac_volumes.size());
}

}  // namespace

void run_case(const std::filesystem::path& case_file, Stage last, const CommonOptions& options)
{
    Case job = read_case(case_file, options.overrides);
    job.deployment.num_frames = options.num_frames.value_or(job.deployment.num_frames);
    OutputFolder folder(options.output.value_or(default_output(case_file)), input_files(job),
                        options.force);
    Progress progress(options.quiet);

    const Chain chain = run_chain(job, last, progress);
    progress.begin("export", "writing the results");
    const std::vector<std::string> notes = write_results(job, chain, last, folder.path());
    std::vector<LawComparison> laws;
    if (options.compare_laws) {
        laws = compare_laws(chain.resistance, job.law);
        write_law_table(folder.path() / "laws.csv", laws);
        write_law_picture(folder.path() / "laws.png", chain.resistance, laws);
    }
    progress.end();
    const auto summary = summarise(job, chain, progress, files_in(folder.path()), notes);
    write_summary(folder.path() / "summary.json", summary);
    put_in_place(folder);

    if (options.quiet) return;
    fmt::print("{}\n{}  {:<28}{}\n", title(job), short_summary(summary), "results",
               folder.final_path().string());
    if (options.compare_laws) fmt::print("{}", law_table(laws));
}

void apply_case_to_foam(const std::filesystem::path& case_file,
                        const std::filesystem::path& foam_case, const CommonOptions& options)
{
    const Case job = read_case(case_file, options.overrides);
    Progress progress(options.quiet);
    const Chain chain = run_chain(job, Stage::deploy, progress);
    progress.begin("export", "applying the resistance to the mesh");
    const FoamCaseOptions foam = job.exports.openfoam.value_or(FoamCaseOptions{});
    const FoamApplication applied =
        apply_to_foam_case(foam_case, chain.resistance,
                           {.form = foam.form,
                            .most_zones = foam.most_zones,
                            .shear_thinning = job.rheology.has_value()});
    progress.end();

    for (const std::string& warning : applied.warnings)
        fmt::print(stderr, "note: {}\n", warning);
    if (const auto warning = sac_count_warning(chain, applied))
        fmt::print(stderr, "note: {}\n", *warning);
    if (job.rheology) fmt::print(stderr, "note: {}\n", rheology_note(job.fluid));
    if (options.quiet) return;
    fmt::print(
        "{}\n  {} of {} cells in {} zones; Darcy integral {:.6g} m of the sheet, {:.6g} m of the "
        "zones\n",
        title(job), applied.num_resistant_cells, applied.num_cells, applied.num_zones,
        applied.integral_sheet, applied.integral_mesh);
    for (const double volume : applied.sac_volumes)
        fmt::print("  sac {:.4g} mm3\n", 1e9 * volume);
    for (const auto& file : applied.files)
        fmt::print("  {}\n", file.string());
}

}  // namespace braidzone

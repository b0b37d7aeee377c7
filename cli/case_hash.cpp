#include "cli/case_hash.hpp"

#include "cli/resolved_case.hpp"
#include "core/file_hash.hpp"

#include <fmt/format.h>

namespace braidzone {

namespace {

void take_off_folder(std::filesystem::path& path)
{
    path = path.filename();
}

}  // namespace

std::vector<InputFile> input_files(const Case& job)
{
    std::vector<InputFile> inputs{{"case", job.file}, {"vessel", job.vessel.surface}};
    if (job.vessel.centerline) inputs.push_back({"centerline", *job.vessel.centerline});
    if (!job.schedule.table_file.empty())
        inputs.push_back({"spacing_table", job.schedule.table_file});
    if (const auto* measured = std::get_if<MeasuredLaw>(&job.law))
        inputs.push_back({"loss_table", measured->table});
    if (job.exports.openfoam && job.exports.openfoam->flow.waveform)
        inputs.push_back({"waveform", job.exports.openfoam->flow.waveform->file});
    if (job.second_device && !job.second_device->schedule.table_file.empty())
        inputs.push_back({"second_spacing_table", job.second_device->schedule.table_file});
    return inputs;
}

std::string case_hash(const Case& job)
{
    Case copy = job;
    take_off_folder(copy.vessel.surface);
    if (copy.vessel.centerline) take_off_folder(*copy.vessel.centerline);
    take_off_folder(copy.schedule.table_file);
    if (copy.second_device) take_off_folder(copy.second_device->schedule.table_file);
    if (auto* measured = std::get_if<MeasuredLaw>(&copy.law)) take_off_folder(measured->table);
    if (copy.exports.openfoam && copy.exports.openfoam->flow.waveform)
        take_off_folder(copy.exports.openfoam->flow.waveform->file);
    std::string text = resolved_case_text(copy);
    for (const InputFile& input : input_files(job)) {
        // What the case file says is in the resolved case.
        if (input.role == "case") continue;
        text += fmt::format("{} {}\n", input.role, sha256_of_file(input.path));
    }
    return sha256_of_text(text);
}

}  // namespace braidzone

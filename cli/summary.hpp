#pragma once

#include "cli/pipeline.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace braidzone {

/// Name by which the record of a folder of results tells which program wrote it.
constexpr const char* program_name = "braidzone";

/// The figures of a run, its resolved case and what it was made with: the content of summary.json.
///
/// `quantities` maps each name to {value, unit}, or to null where it does not apply. They are the
/// first device's, but for the resistance integrals, which are of all devices; `second_device` has
/// the same of the second one. "Neck" is the first of `openings` if a sac lies behind it
/// (`told_apart`), or as it was given.
/// @param files         what the run wrote, relative to its folder
/// @param export_notes  what `write_results` says
nlohmann::ordered_json summarise(const Case& job, const Chain& chain, const Progress& progress,
                                 const std::vector<std::string>& files,
                                 const std::vector<std::string>& export_notes = {});

/// The same in a few lines for the terminal.
std::string short_summary(const nlohmann::ordered_json& summary);

/// True if the file is the summary of an earlier run.
bool is_summary_of_a_run(const std::filesystem::path& file);

}  // namespace braidzone

#include "cli/case_geometry.hpp"
#include "cli/commands.hpp"
#include "cli/output_files.hpp"
#include "core/centerline_io.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace braidzone {
namespace {

/// An end as the command line gives it: an opening's number, or three lengths.
std::optional<CenterlineEnd> parse_end(const std::string& option, const std::string& text)
{
    if (text.empty()) return std::nullopt;
    int opening = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), opening);
    if (error == std::errc() && end == text.data() + text.size() && opening >= 0) return opening;

    std::vector<double> coordinates;
    std::istringstream list(text);
    try {
        for (std::string part; std::getline(list, part, ',');) {
            coordinates.push_back(parse_quantity(part, Dimension::length));
        }
    } catch (const ConfigError&) {
        coordinates.clear();
    }
    if (coordinates.size() == 3) return Vec3(coordinates[0], coordinates[1], coordinates[2]);
    throw ConfigError(
        fmt::format("{} \"{}\" is neither the number of an opening nor a point such as "
                    "\"1 mm, 2 mm, 3 mm\"",
                    option, text));
}

/// The repairs of `--repair=merge,holes`; `--repair` alone means all.
Repairs parse_repairs(const std::string& text)
{
    if (text == "none") return {};
    if (text == "all") return all_repairs;
    const std::vector<std::string> known = repair_names();
    std::vector<std::size_t> places;
    std::istringstream list(text);
    for (std::string name; std::getline(list, name, ',');) {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end()) {
            throw ConfigError(
                fmt::format("--repair \"{}\" is not known{}", name, did_you_mean(name, known)));
        }
        places.push_back(static_cast<std::size_t>(found - known.begin()));
    }
    return repairs_at(places);
}

std::filesystem::path default_output(const std::filesystem::path& surface)
{
    return surface.parent_path() / (surface.stem().string() + "_centerline.vtp");
}

}  // namespace

void write_centerline_of(const CenterlineCommand& command, const CommonOptions& options)
{
    VesselSource source;
    source.surface = command.surface;
    source.unit = length_unit(command.length_unit);
    source.repair = parse_repairs(command.repair);
    source.from = parse_end("--from", command.from);
    source.to = parse_end("--to", command.to);
    if (source.from.has_value() != source.to.has_value()) {
        throw ConfigError("--from and --to are needed together");
    }
    const auto wanted = options.output.value_or(default_output(command.surface));
    OutputFiles files({{"surface", command.surface}}, options.force);
    const auto unfinished = files.add(wanted);

    Progress progress(options.quiet);
    progress.begin("vessel", "reading the vessel");
    const Vessel vessel = read_vessel(source);
    const WallTree wall(vessel);
    progress.begin("centerline", "computing the centerline");
    const Polyline centerline = find_centerline(source, vessel, wall).line;
    progress.end();
    write_centerline(unfinished, centerline, source.unit);
    files.commit();

    if (options.quiet) return;
    fmt::print("openings of {}\n{}\n", command.surface.string(), describe_openings(vessel));
    fmt::print("centerline of {:.4g} mm: {}\n", 1e3 * resample(centerline).length(),
               wanted.string());
}

}  // namespace braidzone

#include "deploy/device_library.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "deploy/device_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>
#include <utility>

namespace braidzone {
namespace {

/// The project's own folder first; later folders win.
std::vector<std::filesystem::path> library_folders()
{
    std::vector<std::filesystem::path> folders = {BRAIDZONE_DEVICES_FOLDER};
    if (const char* listed = std::getenv("BRAIDZONE_DEVICES")) {
        std::istringstream list(listed);
        for (std::string folder; std::getline(list, folder, ':');) {
            if (!folder.empty()) folders.emplace_back(folder);
        }
    }
    return folders;
}

std::vector<std::filesystem::path> device_files_in(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    if (error) {
        throw IoError(
            fmt::format("device folder {} cannot be read: {} (the project's own and those "
                        "in BRAIDZONE_DEVICES are searched)",
                        folder.string(), error.message()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::map<std::string, DeviceFile> read_library()
{
    std::map<std::string, DeviceFile> library;
    for (const auto& folder : library_folders()) {
        for (const auto& path : device_files_in(folder)) {
            DeviceFile file = read_device_file(path);
            library.insert_or_assign(file.model.name, std::move(file));
        }
    }
    return library;
}

bool gives_every_parameter(const TomlTable& section)
{
    const auto is_known = [&](std::string_view key) { return section.has(std::string(key)); };
    return missing_for(ForceSource::springs, is_known).empty() ||
           missing_for(ForceSource::wire_theory, is_known).empty();
}

/// Where the forces come from, see `read_device`.
ForceSource read_forces(const TomlTable& section,
                        const std::function<bool(std::string_view)>& is_known)
{
    if (section.has("forces")) {
        const std::string name = section.text("forces");
        for (const ForceSource source : {ForceSource::springs, ForceSource::wire_theory}) {
            if (name == force_source_name(source)) return source;
        }
        throw ConfigError(fmt::format("{} = \"{}\" is not known; allowed are springs, wire-theory",
                                      section.where("forces"), name));
    }
    const auto& parameters = device_parameters();
    const bool any_spring =
        std::any_of(parameters.begin(), parameters.end(), [&](const DeviceParameter& parameter) {
            return parameter.use == ParameterUse::springs && is_known(parameter.key);
        });
    return any_spring ? ForceSource::springs : ForceSource::wire_theory;
}

/// The library's entry for the device that the section names; an empty one, with the section's name
/// as a mere label, if the section needs no library.
DeviceFile find_device(const TomlTable& section)
{
    const std::string name = section.text_or("name", "custom");
    const auto library = read_library();
    const auto found = library.find(name);
    if (found != library.end()) return found->second;
    if (!section.has("name") || gives_every_parameter(section)) {
        DeviceFile unlisted;
        unlisted.model.name = name;
        return unlisted;
    }
    std::vector<std::string> known;
    for (const auto& [known_name, file] : library)
        known.push_back(known_name);
    throw ConfigError(fmt::format("{} = \"{}\" is not in the device library{}",
                                  section.where("name"), name, did_you_mean(name, known)));
}

bool is_listed(double size, const std::vector<double>& sizes)
{
    // Sizes differ by tenths of a millimetre; the tolerance covers rounding only.
    return std::any_of(sizes.begin(), sizes.end(),
                       [&](double made) { return std::abs(size - made) <= 1e-6 * made; });
}

void check_size(const TomlTable& section, const std::string& key, double size,
                const std::vector<double>& sizes, const DeviceModel& model)
{
    if (sizes.empty() || is_listed(size, sizes)) return;
    std::vector<std::string> made;
    for (const double each : sizes)
        made.push_back(fmt::format("{:.6g}", 1e3 * each));
    throw ConfigError(
        fmt::format("{} = {:.6g} mm: {} is not made in this size; made are {} mm (any_size = true "
                    "allows others)",
                    section.where(key), 1e3 * size, model.name, fmt::join(made, ", ")));
}

std::string show(const DeviceParameter& parameter, double value)
{
    return parameter.dimension ? fmt::format("{:.6g} {}", value, si_unit(*parameter.dimension))
                               : fmt::format("{:.6g}", value);
}

void set_from_case(FlowDiverter& device, const DeviceParameter& parameter, const TomlTable& section)
{
    const std::string key(parameter.key);
    if (parameter.dimension) {
        parameter.set(device, section.quantity(key, *parameter.dimension));
    } else if (parameter.key == "num_wires") {
        const long count = section.integer(key);
        if (!std::in_range<int>(count)) {
            throw ConfigError(fmt::format("{} = {} is out of range; allowed are {} to {}",
                                          section.where(key), count, parameter.lowest,
                                          parameter.highest));
        }
        parameter.set(device, static_cast<double>(count));
    } else {
        parameter.set(device, section.number(key));
    }
}

void set_from_library(FlowDiverter& device, const DeviceParameter& parameter,
                      const SizedValue& known, std::vector<std::string>& notes)
{
    const double value = value_at(known, device.nominal_diameter);
    parameter.set(device, value);
    std::string doubt;
    if (!is_stated_at(known, device.nominal_diameter)) {
        doubt = fmt::format("is not known for {:.6g} mm and follows from other sizes",
                            1e3 * device.nominal_diameter);
    } else if (known.confidence == Confidence::low) {
        doubt = "is of low confidence";
    } else {
        return;
    }
    notes.push_back(fmt::format("device {0}: {1} = {2} {3} (source: braidzone devices {0})",
                                device.name, parameter.key, show(parameter, value), doubt));
}

/// Why a value that the library gives may be none that a braid can have, and what to do.
std::string origin_in_library(const DeviceFile& file, const std::string& key, double diameter)
{
    const auto known = file.parameters.find(key);
    if (known == file.parameters.end() || is_stated_at(known->second, diameter))
        return " (from the library for this size; give it in [device])";
    const auto& all = device_parameters();
    const bool is_of_a_spring = std::any_of(all.begin(), all.end(), [&](const auto& parameter) {
        return parameter.key == key && parameter.use == ParameterUse::springs;
    });
    return fmt::format(" (as it follows from other sizes for {:.6g} mm; give it in [device]{})",
                       1e3 * diameter, is_of_a_spring ? " or state forces = \"wire-theory\"" : "");
}

}  // namespace

std::vector<DeviceModel> device_library()
{
    std::vector<DeviceModel> models;
    for (auto& [name, file] : read_library())
        models.push_back(std::move(file.model));
    return models;
}

FlowDiverter read_device(const TomlTable& section, std::vector<std::string>& notes)
{
    FlowDiverter device;
    device.nominal_diameter = section.quantity("diameter", Dimension::length);
    device.nominal_length = section.quantity("length", Dimension::length);

    const DeviceFile file = find_device(section);
    device.name = file.model.name;
    if (!section.boolean_or("any_size", false)) {
        check_size(section, "diameter", device.nominal_diameter, file.model.nominal_diameters,
                   file.model);
        check_size(section, "length", device.nominal_length, file.model.nominal_lengths,
                   file.model);
    }

    const auto is_in_case = [&](std::string_view key) { return section.has(std::string(key)); };
    const auto is_known = [&](std::string_view key) {
        return is_in_case(key) || file.parameters.contains(key);
    };
    if (is_in_case("braid_ratio") && is_in_case("nominal_porosity")) {
        throw ConfigError(
            fmt::format("{} stands beside braid_ratio, which follows from it: keep "
                        "one of them",
                        section.where("nominal_porosity")));
    }
    device.forces = read_forces(section, is_known);
    const std::vector<std::string> missing = missing_for(device.forces, is_known);
    if (!missing.empty()) {
        throw ConfigError(fmt::format(
            "{}: device {} is incomplete; with forces = \"{}\" these keys must be given in "
            "[device]: {}",
            section.where("name"), device.name, force_source_name(device.forces),
            fmt::join(missing, ", ")));
    }
    std::vector<std::string> doubts;
    for (const DeviceParameter& parameter : device_parameters()) {
        // Of braid ratio and porosity, what the case gives counts, then what the library states.
        if (parameter.use == ParameterUse::porosity && !is_in_case(parameter.key) &&
            is_known("braid_ratio"))
            continue;
        if (parameter.key == "braid_ratio" && is_in_case("nominal_porosity")) continue;
        const auto known = file.parameters.find(parameter.key);
        if (is_in_case(parameter.key)) {
            set_from_case(device, parameter, section);
        } else if (known != file.parameters.end()) {
            const bool counts =
                device.forces == ForceSource::springs || parameter.use != ParameterUse::springs;
            set_from_library(device, parameter, known->second, counts ? notes : doubts);
        }
    }
    if (const auto invalid = find_invalid(device)) {
        throw ConfigError(
            fmt::format("{} {}{}", section.where(invalid->key), invalid->finding,
                        section.has(invalid->key)
                            ? ""
                            : origin_in_library(file, invalid->key, device.nominal_diameter)));
    }
    return device;
}

}  // namespace braidzone

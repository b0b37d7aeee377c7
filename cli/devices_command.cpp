#include "cli/commands.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "deploy/device_library.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace braidzone {
namespace {

std::string_view word(Confidence confidence)
{
    switch (confidence) {
        case Confidence::high:
            return "high";
        case Confidence::medium:
            return "medium";
        case Confidence::low:
            break;
    }
    return "low";
}

/// "springs, wire-theory", the first being the default; "-" for an incomplete device.
std::string forces(const DeviceModel& model)
{
    std::vector<std::string_view> names;
    for (const ForceSource source : model.force_sources)
        names.push_back(force_source_name(source));
    return names.empty() ? "-" : fmt::format("{}", fmt::join(names, ", "));
}

void list_devices(const std::vector<DeviceModel>& models)
{
    fmt::print("{:<20}{:<12}{:<22}{}\n", "name", "values", "forces from", "device");
    for (const DeviceModel& model : models) {
        fmt::print("{:<20}{:<12}{:<22}{}\n", model.name, model.complete ? "complete" : "incomplete",
                   forces(model), model.title);
    }
    fmt::print(
        "\nAn incomplete device needs its missing values in [device] of the case file;\n"
        "`braidzone devices NAME` shows them.\n");
}

void show_device(const DeviceModel& model)
{
    fmt::print("{}: {}\n{}\n\n", model.name, model.title, model.file.string());
    for (const SourcedValue& value : model.values) {
        fmt::print("{:<22}{}\n{:<22}confidence {}: {}\n", value.name, value.value, "",
                   word(value.confidence), value.source);
    }
    if (model.complete) fmt::print("\nforces from: {}\n", forces(model));
    if (!model.complete) fmt::print("\nnot known: {}\n", fmt::join(model.missing, ", "));
}

}  // namespace

void show_devices(const std::string& name)
{
    const std::vector<DeviceModel> models = device_library();
    if (name.empty()) return list_devices(models);
    std::vector<std::string> known;
    for (const DeviceModel& model : models) {
        if (model.name == name) return show_device(model);
        known.push_back(model.name);
    }
    throw ConfigError(
        fmt::format("\"{}\" is not in the device library{}", name, did_you_mean(name, known)));
}

}  // namespace braidzone

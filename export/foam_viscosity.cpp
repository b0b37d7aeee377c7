#include "export/foam_viscosity.hpp"

#include "core/error.hpp"
#include "export/foam_format.hpp"

#include <charconv>
#include <string>

namespace braidzone {

namespace {

/// Skips `{ ... }`, which comes next.
void skip_block(FoamReader& reader)
{
    reader.expect('{');
    while (reader.peek() != '}') {
        if (reader.peek() == '\0') reader.fail("a } is missing");
        if (reader.word().empty()) reader.fail("an entry is expected");
        if (reader.peek() == '{')
            skip_block(reader);
        else
            reader.entry();
    }
    reader.expect('}');
}

/// The last word of an entry such as "nu [0 2 -1 0 0 0 0] 3.3e-6".
std::string last_word(const std::string& entry)
{
    const auto end = entry.find_last_not_of(" \t\r\n");
    if (end == std::string::npos) return "";
    const auto space = entry.find_last_of(" \t\r\n]", end);
    const auto begin = space == std::string::npos ? 0 : space + 1;
    return entry.substr(begin, end + 1 - begin);
}

std::optional<double> number(const std::string& word)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

std::optional<double> newtonian_viscosity(FoamReader reader)
{
    std::optional<double> viscosity;
    while (reader.peek() != '\0') {
        const std::string key = reader.word();
        if (key.empty()) return std::nullopt;  // not a plain dictionary
        if (reader.peek() == '{') {
            skip_block(reader);
            continue;
        }
        const std::string value = last_word(reader.entry());
        const bool is_model = key == "transportModel" || key == "viscosityModel";
        if (is_model && value != "Newtonian" && value != "constant") return std::nullopt;
        if (key == "nu") viscosity = number(value);
    }
    return viscosity;
}

}  // namespace

std::optional<double> case_viscosity(const std::filesystem::path& foam_case)
{
    for (const char* name : {"transportProperties", "physicalProperties"}) {
        const auto file = foam_case / "constant" / name;
        if (!foam_file_exists(file)) continue;
        try {
            return newtonian_viscosity(FoamReader(file));
        } catch (const InputError&) {
            return std::nullopt;  // macros and includes are for OpenFOAM to read
        }
    }
    return std::nullopt;
}

}  // namespace braidzone

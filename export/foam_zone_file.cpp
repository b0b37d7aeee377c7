#include "export/foam_zone_file.hpp"

#include "export/foam_format.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace braidzone {

namespace {

std::filesystem::path path_of(const std::filesystem::path& foam_case, const std::string& file)
{
    return foam_case / "constant" / "polyMesh" / file;
}

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/// "List<label>" or "List<bool>" and the list; an empty list may come without the former.
FoamZoneList read_list(FoamReader& reader, const std::string& key)
{
    FoamZoneList list{key, "label", {}};
    if (reader.peek() == 'L' && reader.word() == "List<bool>") list.type = "bool";
    list.values = list.type == "bool" ? reader.bools() : reader.labels();
    return list;
}

}  // namespace

std::vector<FoamZoneEntry> read_foam_zone_file(const std::filesystem::path& foam_case,
                                               const std::string& file)
{
    std::vector<FoamZoneEntry> zones;
    if (!foam_file_exists(path_of(foam_case, file))) return zones;
    FoamReader reader(path_of(foam_case, file));
    if (reader.peek() != '(') reader.label();  // their number
    // An empty binary list ends with its number.
    if (reader.peek() == '\0') return zones;
    reader.expect('(');
    while (reader.peek() != ')') {
        FoamZoneEntry zone;
        zone.name = reader.word();
        reader.expect('{');
        while (reader.peek() != '}') {
            const std::string key = reader.word();
            if (key.empty()) reader.fail("a zone entry is expected");
            if (reader.peek() == 'L' || is_digit(reader.peek()))
                zone.lists.push_back(read_list(reader, key));
            reader.entry();
        }
        reader.expect('}');
        zones.push_back(std::move(zone));
    }
    reader.expect(')');
    return zones;
}

void write_foam_zone_file(const std::filesystem::path& foam_case, const std::string& file,
                          const std::string& type, const std::vector<FoamZoneEntry>& zones)
{
    std::string text = foam_header("regIOobject", "constant/polyMesh", file);
    auto out = std::back_inserter(text);
    fmt::format_to(out, "{}\n(\n", zones.size());
    for (const FoamZoneEntry& zone : zones) {
        fmt::format_to(out, "{}\n{{\n    type {};\n", zone.name, type);
        for (const FoamZoneList& list : zone.lists)
            fmt::format_to(out, "{:<16}List<{}>\n{}\n(\n{}\n)\n;\n", list.key, list.type,
                           list.values.size(), fmt::join(list.values, "\n"));
        text += "}\n";
    }
    text += ")\n";
    write_text_file(path_of(foam_case, file), text);
    // OpenFOAM must not find an older one beside it.
    std::filesystem::remove(path_of(foam_case, file).string() + ".gz");
}

std::vector<int> zone_list(const FoamZoneEntry& zone, const std::string& key)
{
    for (const FoamZoneList& list : zone.lists) {
        if (list.key == key) return list.values;
    }
    return {};
}

}  // namespace braidzone

#include "export/foam_cell_zones.hpp"

#include "export/foam_format.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace braidzone {

namespace {

std::filesystem::path zones_file(const std::filesystem::path& foam_case)
{
    return foam_case / "constant" / "polyMesh" / "cellZones";
}

}  // namespace

std::vector<FoamCellZone> read_cell_zones(const std::filesystem::path& foam_case)
{
    std::vector<FoamCellZone> zones;
    if (!foam_file_exists(zones_file(foam_case))) return zones;
    FoamReader reader(zones_file(foam_case));
    if (reader.peek() != '(') reader.label();  // their number
    // An empty binary list ends with its number.
    if (reader.peek() == '\0') return zones;
    reader.expect('(');
    while (reader.peek() != ')') {
        FoamCellZone zone;
        zone.name = reader.word();
        reader.expect('{');
        while (reader.peek() != '}') {
            const std::string key = reader.word();
            if (key.empty()) reader.fail("a zone entry is expected");
            if (key == "cellLabels") {
                // "List<label>" and the list; an empty list may come without the former.
                if (reader.peek() == 'L') reader.word();
                zone.cells = reader.labels();
            }
            reader.entry();
        }
        reader.expect('}');
        zones.push_back(std::move(zone));
    }
    reader.expect(')');
    return zones;
}

void write_cell_zones(const std::filesystem::path& foam_case,
                      const std::vector<FoamCellZone>& zones)
{
    std::string text = foam_header("regIOobject", "constant/polyMesh", "cellZones");
    auto out = std::back_inserter(text);
    fmt::format_to(out, "{}\n(\n", zones.size());
    for (const FoamCellZone& zone : zones)
        fmt::format_to(
            out, "{}\n{{\n    type cellZone;\ncellLabels      List<label>\n{}\n(\n{}\n)\n;\n}}\n",
            zone.name, zone.cells.size(), fmt::join(zone.cells, "\n"));
    text += ")\n";
    write_text_file(zones_file(foam_case), text);
    // OpenFOAM must not find an older one beside it.
    std::filesystem::remove(zones_file(foam_case).string() + ".gz");
}

}  // namespace braidzone

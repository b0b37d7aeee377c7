#include "cli/diagnosis_page.hpp"

#include "core/base64.hpp"
#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

namespace braidzone {
namespace {

using Json = nlohmann::ordered_json;
using Row = std::vector<std::string>;

constexpr const char* style =
    "body{font:16px/1.5 sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;margin:.5em 0 1.5em}"
    "th,td{border-bottom:1px solid #ccc;padding:.25em .9em .25em 0;text-align:left;"
    "vertical-align:top}"
    "img{max-width:100%}.answer{font-size:1.25em;border-left:5px solid #2b6cb0;padding-left:.8em}"
    "code{font-size:.9em;overflow-wrap:anywhere}";

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '&':
                result += "&amp;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string table(const Row& heads, const std::vector<Row>& rows)
{
    std::string text = "<table>\n<tr>";
    for (const std::string& head : heads)
        text += fmt::format("<th>{}</th>", escaped(head));
    text += "</tr>\n";
    for (const Row& row : rows) {
        text += "<tr>";
        for (const std::string& cell : row)
            text += fmt::format("<td>{}</td>", escaped(cell));
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

std::string section(const std::string& title, const std::string& content)
{
    return fmt::format("<h2>{}</h2>\n{}", escaped(title), content);
}

/// A number with so many significant digits, "-" for none.
std::string number(const Json& value, int digits = 3)
{
    return value.is_number() ? fmt::format("{:.{}g}", value.get<double>(), digits) : "-";
}

/// "0.048 / 0.090 / 0.089", or "-".
std::string figures(const Json& gap)
{
    if (!gap.is_object()) return "-";
    std::vector<std::string> texts;
    for (const auto& [name, figure] : gap.items())
        texts.push_back(number(figure["value"]));
    return fmt::format("{}", fmt::join(texts, " / "));
}

std::string gaps(const Json& diagnosis)
{
    std::vector<Row> rows;
    for (const auto& [place, gap] : diagnosis["gaps"].items()) {
        std::string name = place;
        std::replace(name.begin(), name.end(), '_', ' ');
        rows.push_back({name, figures(gap["before"]), figures(gap["after"]),
                        figures(gap["noise_floor"]),
                        gap.contains("closure") ? number(gap["closure"]) : "-"});
    }
    return table({"where", "before", "after", "noise floor", "closure"}, rows) +
           "<p>Root mean square / 95th percentile / largest smoothed gap, in mm. The gap that is "
           "held out is predicted from other parts of the device; closure is the share of it above "
           "the noise floor that is gone.</p>\n";
}

std::string scalars(const Json& diagnosis)
{
    std::vector<Row> rows;
    for (const auto& [name, scalar] : diagnosis["scalars"].items()) {
        rows.push_back(
            {name, fmt::format("{} +- {}", number(scalar["measured"], 4), number(scalar["sd"], 2)),
             number(scalar["before"], 4),
             scalar.contains("after") ? number(scalar["after"], 4) : "-"});
    }
    if (rows.empty()) return "";
    return section("Ends and length [mm]", table({"", "measured", "before", "after"}, rows));
}

std::string channels(const Json& diagnosis)
{
    std::vector<Row> rows;
    for (const Json& channel : diagnosis["channels"]) {
        const std::string measured =
            channel["measured"].is_number()
                ? number(channel["measured"], 4) + " +- " + number(channel["sd"], 2)
                : "-";
        rows.push_back({fmt::format("{} [{}]", channel["title"].get<std::string>(),
                                    channel["unit"].get<std::string>()),
                        number(channel["before"], 4), number(channel["after"], 4), measured});
    }
    return section("Length, density and force",
                   table({"simulated", "before", "after", "measured"}, rows));
}

std::string further(const Json& diagnosis)
{
    const Json& found = diagnosis["further_measurement"];
    std::vector<Row> rows;
    for (const Json& channel : found["channels"]) {
        for (const Json& pair : channel["pairs"]) {
            rows.push_back({channel["measurement"].get<std::string>(),
                            pair["first"].get<std::string>(), pair["second"].get<std::string>(),
                            number(pair["now"], 2), number(pair["with"], 2)});
        }
    }
    if (rows.empty()) return "";
    return section(
        "What would separate the answers",
        table({"a measurement of", "tells", "from", "d' now", "d' with it"}, rows) +
            "<p>d' is by how many standard deviations two answers are told apart: now by "
            "their Bayes factor, then by what the one could still explain of the "
            "other's prediction. A measurement that brings 3 or more by itself "
            "decides.</p>\n");
}

std::string clusters(const Json& diagnosis)
{
    std::vector<Row> rows;
    for (const Json& cluster : diagnosis["clusters"]) {
        rows.push_back({fmt::format("{} to {}", number(cluster["from"]["value"], 4),
                                    number(cluster["to"]["value"], 4)),
                        number(cluster["angle"]["value"]), cluster["label"].get<std::string>(),
                        number(cluster["mean_gap"]["value"]),
                        number(cluster["largest_gap"]["value"]), number(cluster["area"]["value"]),
                        number(cluster["p_family_wise"], 2)});
    }
    if (rows.empty()) return "<p>No patches stand out.</p>\n";
    return table({"along [mm]", "around [deg]", "lies", "mean gap [mm]", "largest [mm]",
                  "area [mm2]", "family-wise p"},
                 rows);
}

std::string parameters(const Json& fit)
{
    if (fit.contains("failure"))
        return "could not be simulated: " + fit["failure"].get<std::string>();
    std::vector<std::string> texts;
    for (const auto& [effect, all] : fit["parameters"].items()) {
        for (const auto& [name, parameter] : all.items()) {
            const std::string unit = parameter["unit"].get<std::string>();
            texts.push_back(fmt::format("{} {} +- {}{}", name, number(parameter["value"], 4),
                                        number(parameter["sd"], 2), unit == "1" ? "" : " " + unit));
        }
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string evidence(const Json& diagnosis)
{
    std::vector<Row> rows;
    for (const Json& fit : diagnosis["effects"]) {
        rows.push_back(
            {fit["effect"].get<std::string>(), number(fit.value("log_bayes_factor", Json())),
             number(fit.value("log_bayes_factor_unknown_besides", Json())), parameters(fit)});
    }
    rows.push_back({"an unknown effect", number(diagnosis["log_bayes_factor_unknown"]), "-", ""});
    return table({"effect", "ln Bayes factor", "unknown besides", "parameters"}, rows) +
           "<p>Natural logarithms of Bayes factors: against no effect, and of an unknown effect "
           "that comes on top of the known one.</p>\n";
}

std::string notes(const Json& diagnosis)
{
    if (diagnosis["warnings"].empty()) return "";
    std::string text = "<ul>\n";
    for (const Json& warning : diagnosis["warnings"])
        text += fmt::format("<li>{}</li>\n", escaped(warning.get<std::string>()));
    return section("Notes", text + "</ul>\n");
}

std::string inputs(const Json& diagnosis)
{
    std::string rows;
    for (const auto& [name, input] : diagnosis["inputs"].items()) {
        rows +=
            fmt::format("<tr><td>{}</td><td><code>{}</code><br><code>sha256 {}</code></td></tr>\n",
                        escaped(name), escaped(input["path"].get<std::string>()),
                        input["sha256"].get<std::string>());
    }
    return section("Inputs", fmt::format("<table>\n{}</table>\n", rows));
}

std::string embedded(const std::filesystem::path& picture)
{
    std::ifstream file(picture, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!file || bytes.empty())
        throw IoError(fmt::format("picture {} cannot be read", picture.string()));
    return fmt::format(
        "<p><img alt=\"gap before and after\" src=\"data:image/png;base64,{}\"></p>\n",
        base64_of(bytes));
}

/// Title, answer and picture, then what belongs to the observable.
std::string page(const Json& diagnosis, const std::filesystem::path& picture,
                 const std::string& title, const std::string& content)
{
    return fmt::format(
               "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<title>Diagnosis</title>\n<style>{}</style>\n</head>\n<body>\n"
               "<h1>{}</h1>\n<p class=\"answer\">{}</p>\n",
               style, escaped(title), escaped(diagnosis["answer"]["text"].get<std::string>())) +
           embedded(picture) + content + notes(diagnosis) + inputs(diagnosis) +
           "</body>\n</html>\n";
}

std::string percentage(const Json& share)
{
    return share.is_number() ? fmt::format("{:.2f} %", 100.0 * share.get<double>()) : "-";
}

std::string curve_gap(const Json& gaps)
{
    return table({"", "before", "after", "noise floor"},
                 {{"gap, held out", percentage(gaps["before"]), percentage(gaps["after"]),
                   percentage(gaps["noise_floor"])}}) +
           "<p>Root mean square over the simulated curve; each of four blocks of points is "
           "predicted from the others.</p>\n";
}

std::string separating(const Json& diagnosis)
{
    if (diagnosis["separated_by"].empty()) return "";
    std::string text = "<ul>\n";
    for (const Json& line : diagnosis["separated_by"])
        text += fmt::format("<li>{}</li>\n", escaped(line.get<std::string>()));
    return section("What would tell them apart", text + "</ul>\n");
}

/// Every number of every point, under the names of diagnosis.json.
std::string points(const Json& diagnosis)
{
    Row heads;
    std::vector<Row> rows;
    for (const auto& [name, value] : diagnosis["points"].front().items())
        heads.push_back(name);
    for (const Json& point : diagnosis["points"]) {
        rows.emplace_back();
        for (const auto& [name, value] : point.items())
            rows.back().push_back(number(value, 4));
    }
    return section("The points", table(heads, rows));
}

}  // namespace

std::string diagnosis_page(const Json& diagnosis, const std::filesystem::path& picture)
{
    return page(diagnosis, picture, "Simulation and measurement",
                section("The gap", gaps(diagnosis)) + scalars(diagnosis) + channels(diagnosis) +
                    further(diagnosis) + section("Where they differ", clusters(diagnosis)) +
                    section("Which effect", evidence(diagnosis)));
}

std::string curve_page(const Json& diagnosis, const std::filesystem::path& picture)
{
    return page(diagnosis, picture,
                "Simulated and measured " + diagnosis["observable"].get<std::string>(),
                section("The gap", curve_gap(diagnosis["gaps"])) + separating(diagnosis) +
                    section("Which effect", evidence(diagnosis)) + points(diagnosis));
}

}  // namespace braidzone

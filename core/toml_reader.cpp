#include "core/toml_reader.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace braidzone {
namespace {

/// One parsed file, shared by all handles on its tables.
struct Document {
    std::filesystem::path path;
    toml::table root;
    std::set<std::string> overridden;  ///< dotted names of the keys that an override set
};

std::string read_text(const std::filesystem::path& path)
{
    if (std::filesystem::is_directory(path)) {
        throw IoError(fmt::format("{} is a folder; a TOML file is expected", path.string()));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw IoError(fmt::format("{} cannot be opened", path.string()));
    std::ostringstream text;
    text << file.rdbuf();
    if (file.bad()) throw IoError(fmt::format("{} cannot be read", path.string()));
    return std::move(text).str();
}

std::vector<std::string> split_at_dots(const std::string& dotted)
{
    std::vector<std::string> parts(1);
    for (const char c : dotted) {
        if (c == '.') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

bool is_bare_key(const std::string& key)
{
    constexpr std::string_view allowed =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !key.empty() && key.find_first_not_of(allowed) == std::string::npos;
}

/// Sets the value in a table: as TOML if it is valid TOML, else as a string. So a string with
/// spaces needs no quotes within the quotes that a shell asks for.
void insert_value(toml::table& table, const std::string& key, const std::string& value)
{
    try {
        toml::table parsed = toml::parse("value = " + value);
        if (parsed.size() == 1) {  // a line break in the value could add keys
            table.insert_or_assign(key, std::move(*parsed.get("value")));
            return;
        }
    } catch (const toml::parse_error&) {
    }
    table.insert_or_assign(key, value);
}

void apply_override(Document& document, const std::string& override_text)
{
    const auto equals = override_text.find('=');
    const std::string dotted = override_text.substr(0, equals);
    const std::vector<std::string> parts = split_at_dots(dotted);
    if (equals == std::string::npos || !std::all_of(parts.begin(), parts.end(), is_bare_key)) {
        throw ConfigError(
            fmt::format("--set \"{}\" is not of the form section.key=value", override_text));
    }
    toml::table* table = &document.root;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        toml::node* node = table->get(parts[i]);
        if (!node) node = &table->insert(parts[i], toml::table{}).first->second;
        table = node->as_table();
        if (!table) {
            throw ConfigError(fmt::format("--set {}: {} is no section with keys that can be set",
                                          override_text, parts[i]));
        }
    }
    insert_value(*table, parts.back(), override_text.substr(equals + 1));
    document.overridden.insert(dotted);
}

/// What a value is, in the words of the TOML specification.
std::string_view kind_of(const toml::node& node)
{
    switch (node.type()) {
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "an integer";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "a boolean";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::table:
            return "a table";
        default:
            return "a date or time";
    }
}

/// Of a point from the origin of a scanner's frame [m], in which a patient lies.
constexpr double largest_coordinate = 10.0;

/// "= 0.4", as it stands in the file.
std::string value_text(const toml::node& node)
{
    std::ostringstream text;
    if (node.is_string()) {
        text << '"' << **node.as_string() << '"';
    } else if (node.is_floating_point()) {
        text << fmt::format(
            "{}", **node.as_floating_point());  // shortest form: 0.4, not 0.40000000000000002
    } else {
        node.visit([&](const auto& value) { text << value; });
    }
    return "= " + text.str();
}

/// The value and what it is, for messages; arrays and tables are not spelled out.
std::string shown(const toml::node& node)
{
    if (node.is_array() || node.is_table()) return fmt::format("is {}", kind_of(node));
    return fmt::format("{} is {}", value_text(node), kind_of(node));
}

}  // namespace

struct TomlTable::State {
    std::shared_ptr<const Document> document;
    const toml::table* table = nullptr;  ///< null for a table that is not in the file
    std::string name;                    ///< dotted, "" for the document
    unsigned line = 0;                   ///< 0 if it has none
    std::set<std::string> asked;
    /// Dimensions of the numeric values that were read; none for plain numbers.
    std::map<std::string, std::optional<Dimension>> numeric;
    std::map<std::string, std::vector<std::shared_ptr<State>>> opened;

    std::string full_name(const std::string& key) const
    {
        return name.empty() ? key : name + "." + key;
    }

    const toml::node* find(const std::string& key)
    {
        asked.insert(key);
        return table ? table->get(key) : nullptr;
    }

    std::string place(const std::string& key) const
    {
        const std::string full = full_name(key);
        if (document->overridden.contains(full)) return "--set " + full;
        const toml::node* node = table ? table->get(key) : nullptr;
        const unsigned at = node && node->source().begin.line ? node->source().begin.line : line;
        return at ? fmt::format("{}:{}: {}", document->path.string(), at, full)
                  : fmt::format("{}: {}", document->path.string(), full);
    }

    const toml::node& require(const std::string& key, std::string_view expected)
    {
        const toml::node* node = find(key);
        if (!node)
            throw ConfigError(fmt::format("{} is missing; expected is {}", place(key), expected));
        return *node;
    }

    ConfigError wrong_type(const std::string& key, const toml::node& node,
                           std::string_view expected) const
    {
        return ConfigError(fmt::format("{} {}; expected is {}", place(key), shown(node), expected));
    }

    template <typename Value>
    Value value(const std::string& key, std::string_view expected)
    {
        const toml::node& node = require(key, expected);
        if (!node.is<Value>()) throw wrong_type(key, node, expected);
        return **node.as<Value>();
    }

    double parse(const std::string& key, const toml::node& node, Dimension dimension)
    {
        numeric[key] = dimension;
        if (!node.is_string()) {
            throw wrong_type(key, node,
                             fmt::format("a string with a number and a unit of {}: {}",
                                         dimension_name(dimension), allowed_units(dimension)));
        }
        try {
            return parse_quantity(**node.as_string(), dimension);
        } catch (const ConfigError& error) {
            throw ConfigError(fmt::format("{} = {}", place(key), error.what()));
        }
    }

    /// A plain number, or none if it is no number or none that a double holds.
    double parse_number(const std::string& key, const toml::node& node, std::string_view expected)
    {
        numeric[key] = std::nullopt;
        if (!node.is_number()) throw wrong_type(key, node, expected);
        const std::optional<double> value = node.value<double>();
        if (!value) {
            throw wrong_type(key, node, "one of at most 2^53 = 9007199254740992, to be exact");
        }
        return *value;
    }

    void require_range(const std::string& key, const toml::node& node, const KeyRange& range) const
    {
        if (const toml::array* array = node.as_array()) {
            for (const toml::node& element : *array)
                require_range(key, element, range);
            return;
        }
        const std::optional<Dimension> dimension = numeric.at(key);
        const auto si = [&](const std::string& text) {
            return dimension ? parse_quantity(text, *dimension) : std::stod(text);
        };
        const double value =
            dimension ? parse_quantity(**node.as_string(), *dimension) : *node.value<double>();
        if (value >= si(range.lowest) && value <= si(range.highest)) return;
        throw ConfigError(fmt::format("{} {} is out of range; allowed are {} to {}", place(key),
                                      value_text(node), range.lowest, range.highest));
    }

    void require_ranges(const KeyRanges& ranges) const
    {
        for (const auto& [key, dimension] : numeric) {
            const toml::node* node = table ? table->get(key) : nullptr;
            if (!node) continue;
            const auto range =
                std::find_if(ranges.begin(), ranges.end(),
                             [&](const KeyRange& each) { return each.key == full_name(key); });
            if (range == ranges.end())
                throw std::logic_error("no range is declared for " + full_name(key));
            require_range(key, *node, *range);
        }
        for (const auto& [key, states] : opened) {
            for (const auto& state : states)
                state->require_ranges(ranges);
        }
    }

    std::shared_ptr<State> child(const std::string& key, const toml::table* child_table) const
    {
        auto state = std::make_shared<State>();
        state->document = document;
        state->table = child_table;
        state->name = full_name(key);
        state->line = child_table && child_table->source().begin.line
                          ? child_table->source().begin.line
                          : line;
        return state;
    }

    void finish() const
    {
        if (table) {
            for (const auto& [key, node] : *table) {
                const std::string unknown(key.str());
                if (asked.contains(unknown)) continue;
                throw ConfigError(fmt::format("{}: unknown key{}", place(unknown),
                                              did_you_mean(unknown, {asked.begin(), asked.end()})));
            }
        }
        for (const auto& [key, states] : opened) {
            for (const auto& state : states)
                state->finish();
        }
    }
};

TomlTable::TomlTable(std::shared_ptr<State> state) : state_(std::move(state)) {}

TomlTable TomlTable::read_file(const std::filesystem::path& path,
                               const std::vector<std::string>& overrides)
{
    auto document = std::make_shared<Document>();
    document->path = path;
    try {
        document->root = toml::parse(read_text(path), path.string());
    } catch (const toml::parse_error& error) {
        throw ConfigError(fmt::format("{}:{}: not valid TOML: {}", path.string(),
                                      error.source().begin.line, error.description()));
    }
    for (const std::string& override_text : overrides)
        apply_override(*document, override_text);

    auto state = std::make_shared<State>();
    state->table = &document->root;
    state->document = std::move(document);
    return TomlTable(std::move(state));
}

bool TomlTable::has(const std::string& key) const
{
    return state_->find(key) != nullptr;
}

std::string TomlTable::text(const std::string& key) const
{
    return state_->value<std::string>(key, "a string");
}

double TomlTable::number(const std::string& key) const
{
    const toml::node& node = state_->require(key, "a number");
    const double value = state_->parse_number(key, node, "a number");
    if (!std::isfinite(value)) throw state_->wrong_type(key, node, "a finite one");
    return value;
}

long TomlTable::integer(const std::string& key) const
{
    state_->numeric[key] = std::nullopt;
    return state_->value<std::int64_t>(key, "an integer");
}

bool TomlTable::boolean(const std::string& key) const
{
    return state_->value<bool>(key, "true or false");
}

double TomlTable::quantity(const std::string& key, Dimension dimension) const
{
    const std::string expected =
        fmt::format("a {} with its unit: {}", dimension_name(dimension), allowed_units(dimension));
    return state_->parse(key, state_->require(key, expected), dimension);
}

Vec3 TomlTable::point(const std::string& key) const
{
    constexpr std::string_view expected = R"(a point: ["x mm", "y mm", "z mm"])";
    const toml::node& node = state_->require(key, expected);
    const toml::array* coordinates = node.as_array();
    if (!coordinates || coordinates->size() != 3) throw state_->wrong_type(key, node, expected);
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        point[axis] = state_->parse(key, *coordinates->get(static_cast<std::size_t>(axis)),
                                    Dimension::length);
    }
    state_->numeric.erase(key);  // its range is that of every point
    if (!(point.cwiseAbs().maxCoeff() <= largest_coordinate)) {
        throw ConfigError(fmt::format("{} has a coordinate of {:.6g} m; allowed are -{} to {} m",
                                      where(key), point.cwiseAbs().maxCoeff(), largest_coordinate,
                                      largest_coordinate));
    }
    return point;
}

std::vector<double> TomlTable::quantities(const std::string& key, Dimension dimension) const
{
    const std::string expected = fmt::format("an array of strings, each a {} with its unit: {}",
                                             dimension_name(dimension), allowed_units(dimension));
    const toml::node& node = state_->require(key, expected);
    if (!node.is_array()) throw state_->wrong_type(key, node, expected);
    std::vector<double> values;
    for (const toml::node& element : *node.as_array()) {
        values.push_back(state_->parse(key, element, dimension));
    }
    return values;
}

std::vector<double> TomlTable::numbers(const std::string& key) const
{
    constexpr std::string_view expected = "an array of finite numbers";
    const toml::node& node = state_->require(key, expected);
    if (!node.is_array()) throw state_->wrong_type(key, node, expected);
    std::vector<double> values;
    for (const toml::node& element : *node.as_array()) {
        values.push_back(state_->parse_number(key, element, expected));
        if (!std::isfinite(values.back())) throw state_->wrong_type(key, element, expected);
    }
    return values;
}

std::vector<std::string> TomlTable::texts(const std::string& key) const
{
    constexpr std::string_view expected = "an array of strings";
    const toml::node& node = state_->require(key, expected);
    if (!node.is_array()) throw state_->wrong_type(key, node, expected);
    std::vector<std::string> values;
    for (const toml::node& element : *node.as_array()) {
        if (!element.is_string()) throw state_->wrong_type(key, element, expected);
        values.push_back(**element.as_string());
    }
    return values;
}

std::string TomlTable::text_or(const std::string& key, const std::string& fallback) const
{
    return has(key) ? text(key) : fallback;
}

double TomlTable::number_or(const std::string& key, double fallback) const
{
    return has(key) ? number(key) : fallback;
}

long TomlTable::integer_or(const std::string& key, long fallback) const
{
    return has(key) ? integer(key) : fallback;
}

bool TomlTable::boolean_or(const std::string& key, bool fallback) const
{
    return has(key) ? boolean(key) : fallback;
}

double TomlTable::quantity_or(const std::string& key, Dimension dimension, double fallback) const
{
    return has(key) ? quantity(key, dimension) : fallback;
}

bool TomlTable::is_array(const std::string& key) const
{
    const toml::node* node = state_->find(key);
    return node && node->is_array();
}

bool TomlTable::is_text(const std::string& key) const
{
    const toml::node* node = state_->find(key);
    return node && node->is_string();
}

TomlTable TomlTable::table(const std::string& key) const
{
    const toml::node& node =
        state_->require(key, fmt::format("a section [{}]", state_->full_name(key)));
    if (!node.is_table()) throw state_->wrong_type(key, node, "a table");
    auto& states = state_->opened[key];
    if (states.empty()) states.push_back(state_->child(key, node.as_table()));
    return TomlTable(states.front());
}

TomlTable TomlTable::table_or_empty(const std::string& key) const
{
    return has(key) ? table(key) : TomlTable(state_->child(key, nullptr));
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const
{
    const toml::node* node = state_->find(key);
    if (!node) return {};
    const std::string expected = fmt::format("an array of tables [[{}]]", state_->full_name(key));
    if (!node->is_array()) throw state_->wrong_type(key, *node, expected);
    auto& states = state_->opened[key];
    if (states.empty()) {
        for (const toml::node& element : *node->as_array()) {
            if (!element.is_table()) throw state_->wrong_type(key, element, expected);
            states.push_back(state_->child(key, element.as_table()));
        }
    }
    std::vector<TomlTable> handles;
    for (const auto& state : states)
        handles.push_back(TomlTable(state));
    return handles;
}

std::vector<std::string> TomlTable::keys() const
{
    if (!state_->table) return {};
    // toml++ holds keys in alphabetical order; their places in the text tell the order there.
    std::vector<const toml::key*> in_order;
    for (const auto& [key, node] : *state_->table)
        in_order.push_back(&key);
    std::stable_sort(in_order.begin(), in_order.end(),
                     [](const toml::key* first, const toml::key* second) {
                         return first->source().begin < second->source().begin;
                     });
    std::vector<std::string> names;
    for (const toml::key* key : in_order)
        names.emplace_back(key->str());
    return names;
}

void TomlTable::finish() const
{
    state_->finish();
}

void TomlTable::require_ranges(const KeyRanges& ranges) const
{
    state_->require_ranges(ranges);
}

std::string TomlTable::where(const std::string& key) const
{
    return state_->place(key);
}

std::filesystem::path TomlTable::folder() const
{
    return std::filesystem::absolute(state_->document->path).parent_path();
}

std::string TomlTable::document_text() const
{
    std::ostringstream text;
    text << state_->document->root;
    return std::move(text).str();
}

}  // namespace braidzone

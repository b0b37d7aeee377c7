#include "deploy/deployment_measures.hpp"
#include "export/axis_ticks.hpp"
#include "export/braid_cells.hpp"
#include "export/canvas.hpp"
#include "export/colour_map.hpp"
#include "export/unrolled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace braidzone {

namespace {

constexpr double millimetre = 1e-3;           // [m]
constexpr double millimetre_hg = 133.322368;  // [Pa], conventional millimetre of mercury

/// A coloured cell of a map: a rhombus of the lattice's size around a node or a pore.
struct Tile {
    Vec2 centre = Vec2::Zero();  ///< around and along the force-free device [m]
    double value = 0.0;          ///< in the unit of the map
};

struct Map {
    std::string title;
    std::string unit;  ///< none for a map of two states
    std::vector<Tile> tiles;
};

/// Colour range of a map.
struct Range {
    double lower = 0.0;
    double upper = 1.0;
    bool clips_below = false;  ///< some values lie below and are shown like the lower end
    bool clips_above = false;
};

/// Measures of the picture [pixels].
struct Layout {
    double scale = 0.0;  ///< pixels a metre of the unfolded surface
    double map_width = 0.0;
    double map_height = 0.0;

    static constexpr double largest_map_width = 440.0;
    static constexpr double largest_map_height = 760.0;
    static constexpr double top = 76.0;
    static constexpr double bottom = 84.0;
    static constexpr double left = 110.0;
    static constexpr double right = 0.0;
    static constexpr double bar_gap = 18.0;
    static constexpr double bar_width = 22.0;
    static constexpr double panel_gap = 150.0;  ///< from map to map: colour scale with its labels
    static constexpr double tick_length = 6.0;
    static constexpr double label_gap = 6.0;
    static constexpr double font_size = 17.0;
    static constexpr double title_size = 21.0;

    double width(std::size_t maps) const
    {
        return left + static_cast<double>(maps) * (map_width + panel_gap) + right;
    }
    double height() const { return top + map_height + bottom; }
};

template <typename Values>
std::vector<Tile> tiles_of_nodes(const BraidLattice& lattice, const Values& values, double unit)
{
    std::vector<Tile> tiles;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const auto node = static_cast<std::size_t>(lattice.node(ring, column));
            tiles.push_back({surface_coordinates(lattice, ring, column), values[node] / unit});
        }
    }
    return tiles;
}

std::vector<Tile> tiles_of_rhombi(const BraidLattice& lattice, const std::vector<double>& values,
                                  double unit)
{
    std::vector<Tile> tiles;
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const Vec2 centre =
                surface_coordinates(lattice, ring, column) + Vec2(0.0, lattice.ring_spacing);
            tiles.push_back({centre, values[tiles.size()] / unit});
        }
    }
    return tiles;
}

std::vector<Map> make_maps(const Deployment& deployment, const ResistanceSheet& sheet)
{
    const BraidLattice& lattice = deployment.lattice;
    constexpr double percent = 0.01;
    return {{"wall contact", "", tiles_of_nodes(lattice, deployment.in_contact, 1.0)},
            {"density increase", "%",
             tiles_of_rhombi(lattice, sheet.surface.density_increase, percent)},
            {"contact pressure", "mmHg",
             tiles_of_nodes(lattice, deployment.contact_pressure, millimetre_hg)},
            {"radial expansion", "mm",
             tiles_of_nodes(lattice, radial_expansion(deployment), millimetre)}};
}

/// Nearly all values: single extremes at the device's ends must not hide the rest.
Range colour_range(const std::vector<Tile>& tiles)
{
    constexpr double share_outside = 0.01;
    std::vector<double> values;
    for (const Tile& tile : tiles)
        values.push_back(tile.value);
    std::sort(values.begin(), values.end());
    const auto outside =
        static_cast<std::size_t>(share_outside * static_cast<double>(values.size()));
    Range range{values[outside], values[values.size() - 1 - outside]};
    // A uniform field has no range of its own; without this the map would show round-off.
    const double smallest_span =
        std::max(0.02 * std::max(std::abs(range.lower), std::abs(range.upper)), 1e-3);
    if (range.upper - range.lower < smallest_span) {
        const double middle = 0.5 * (range.lower + range.upper);
        range.lower = middle - 0.5 * smallest_span;
        range.upper = middle + 0.5 * smallest_span;
    }
    range.clips_below = values.front() < range.lower;
    range.clips_above = values.back() > range.upper;
    return range;
}

/// Circumference and length of the force-free device, which the maps span [m].
struct Extent {
    double circumference = 0.0;
    double length = 0.0;

    explicit Extent(const BraidLattice& lattice)
        : circumference(2.0 * std::numbers::pi * lattice.nominal_radius),
          length((lattice.num_rings - 1) * lattice.ring_spacing)
    {
    }
};

Layout make_layout(const Extent& extent)
{
    Layout layout;
    layout.scale = std::min(Layout::largest_map_width / extent.circumference,
                            Layout::largest_map_height / extent.length);
    layout.map_width = layout.scale * extent.circumference;
    layout.map_height = layout.scale * extent.length;
    return layout;
}

/// Draws the maps side by side.
class Painter {
public:
    Painter(const BraidLattice& lattice, std::size_t num_maps)
        : lattice_(lattice),
          extent_(lattice),
          layout_(make_layout(extent_)),
          canvas_(layout_.width(num_maps), layout_.height())
    {
    }

    void draw_map(const Map& map, std::size_t place)
    {
        const double left =
            Layout::left + static_cast<double>(place) * (layout_.map_width + Layout::panel_gap);
        const bool has_two_states = map.unit.empty();
        const Range range = has_two_states ? Range{} : colour_range(map.tiles);
        draw_tiles(map.tiles, left, [&](double value) {
            if (has_two_states) return state_colour(value > 0.5);
            return viridis((value - range.lower) / (range.upper - range.lower));
        });
        draw_frame(left, place == 0);
        text(map.title, left + 0.5 * layout_.map_width, Layout::top - 26.0, Align::centre,
             Layout::title_size);
        const double bar_left = left + layout_.map_width + Layout::bar_gap;
        if (has_two_states) {
            draw_states(bar_left);
        } else {
            draw_bar(range, map.unit, bar_left);
        }
    }

    void save(const std::filesystem::path& path) const { canvas_.save(path); }

private:
    /// As in the paper: the wall dark, the neck light.
    static Colour state_colour(bool in_contact) { return viridis(in_contact ? 0.15 : 1.0); }

    void text(const std::string& content, double x, double y, Align align,
              double size = Layout::font_size)
    {
        canvas_.text(content, {x, y}, align, size);
    }

    void line(double x0, double y0, double x1, double y1) { canvas_.line({x0, y0}, {x1, y1}); }

    PictureBox map_box(double left) const
    {
        return {left, Layout::top, layout_.map_width, layout_.map_height};
    }

    double bottom_edge() const { return Layout::top + layout_.map_height; }

    template <typename ColourOf>
    void draw_tiles(const std::vector<Tile>& tiles, double left, const ColourOf& colour_of)
    {
        canvas_.begin_tiles(map_box(left));
        const double half_width = layout_.scale * lattice_.arm_width;
        const double half_height = layout_.scale * lattice_.ring_spacing;
        for (const Tile& tile : tiles) {
            const double y = bottom_edge() - layout_.scale * tile.centre[1];
            // A tile across the cut appears on both sides.
            for (const double turn : {-1.0, 0.0, 1.0}) {
                const double around = tile.centre[0] + turn * extent_.circumference;
                if (around < -lattice_.arm_width ||
                    around > extent_.circumference + lattice_.arm_width) {
                    continue;
                }
                const double x = left + layout_.scale * around;
                canvas_.fill({{x, y + half_height},
                              {x + half_width, y},
                              {x, y - half_height},
                              {x - half_width, y}},
                             colour_of(tile.value));
            }
        }
        canvas_.end_tiles();
    }

    void draw_frame(double left, bool with_vertical_labels)
    {
        canvas_.frame(map_box(left));
        for (const Tick& tick : axis_ticks(0.0, extent_.circumference / millimetre, 6)) {
            const double x = left + layout_.scale * tick.value * millimetre;
            line(x, bottom_edge(), x, bottom_edge() + Layout::tick_length);
            text(tick.label, x,
                 bottom_edge() + Layout::tick_length + Layout::label_gap + Layout::font_size,
                 Align::centre);
        }
        text("around [mm]", left + 0.5 * layout_.map_width, bottom_edge() + 62.0, Align::centre);
        for (const Tick& tick : axis_ticks(0.0, extent_.length / millimetre, 9)) {
            const double y = bottom_edge() - layout_.scale * tick.value * millimetre;
            line(left - Layout::tick_length, y, left, y);
            if (with_vertical_labels) {
                text(tick.label, left - Layout::tick_length - Layout::label_gap,
                     y + 0.35 * Layout::font_size, Align::right);
            }
        }
        if (with_vertical_labels) draw_vertical_title(left);
    }

    void draw_vertical_title(double left)
    {
        canvas_.text("along the force-free device, from its distal end [mm]",
                     {left - 62.0, Layout::top + 0.5 * layout_.map_height}, Align::centre,
                     Layout::font_size, -0.5 * std::numbers::pi);
    }

    void draw_states(double left)
    {
        double y = Layout::top;
        for (const bool in_contact : {false, true}) {
            const PictureBox box{left, y, Layout::bar_width, Layout::bar_width};
            canvas_.fill(box, state_colour(in_contact));
            canvas_.frame(box);
            text(in_contact ? "contact" : "free", left + Layout::bar_width + 10.0,
                 y + 0.5 * Layout::bar_width + 0.35 * Layout::font_size, Align::left);
            y += 1.6 * Layout::bar_width;
        }
    }

    void draw_bar(const Range& range, const std::string& unit, double left)
    {
        const double right = left + Layout::bar_width;
        // Room for the tips that show that values go on beyond the range.
        const double tip = Layout::bar_width;
        const double top = Layout::top + tip, bottom = bottom_edge() - tip;
        const double middle = 0.5 * (left + right);
        canvas_.begin_tiles({left, top, Layout::bar_width, bottom - top});
        const int num_bands = static_cast<int>(bottom - top);
        for (int band = 0; band < num_bands; ++band) {
            const double y0 = bottom + (top - bottom) * band / num_bands;
            const double y1 = bottom + (top - bottom) * (band + 1) / num_bands;
            canvas_.fill({{left, y0}, {right, y0}, {right, y1}, {left, y1}},
                         viridis((band + 0.5) / num_bands));
        }
        canvas_.end_tiles();
        std::vector<Vec2> outline{{left, bottom}};
        if (range.clips_below) {
            canvas_.fill({{left, bottom}, {right, bottom}, {middle, bottom + tip}}, viridis(0.0));
            outline.emplace_back(middle, bottom + tip);
        }
        outline.emplace_back(right, bottom);
        outline.emplace_back(right, top);
        if (range.clips_above) {
            canvas_.fill({{left, top}, {right, top}, {middle, top - tip}}, viridis(1.0));
            outline.emplace_back(middle, top - tip);
        }
        outline.emplace_back(left, top);
        canvas_.outline(outline);

        for (const Tick& tick : axis_ticks(range.lower, range.upper, 8)) {
            const double y =
                bottom + (top - bottom) * (tick.value - range.lower) / (range.upper - range.lower);
            line(right, y, right + Layout::tick_length, y);
            text(tick.label, right + Layout::tick_length + Layout::label_gap,
                 y + 0.35 * Layout::font_size, Align::left);
        }
        text(fmt::format("[{}]", unit), left, Layout::top - 8.0, Align::left);
    }

    const BraidLattice& lattice_;
    Extent extent_;
    Layout layout_;
    Canvas canvas_;
};

}  // namespace

void write_unrolled_picture(const std::filesystem::path& path, const Deployment& deployment,
                            const ResistanceSheet& sheet)
{
    const std::vector<Map> maps = make_maps(deployment, sheet);
    Painter painter(deployment.lattice, maps.size());
    for (std::size_t place = 0; place < maps.size(); ++place)
        painter.draw_map(maps[place], place);
    painter.save(path);
}

}  // namespace braidzone

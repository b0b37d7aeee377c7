#include "cli/discrepancy_picture.hpp"

#include "export/axis_ticks.hpp"
#include "export/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace braidzone {
namespace {

constexpr double map_width = 300.0, map_height = 560.0;
constexpr double left_margin = 100.0, top = 70.0, bottom_margin = 80.0, gap = 50.0;
constexpr double bar_width = 22.0, right_margin = 110.0;
constexpr double font_size = 16.0, title_size = 20.0;
constexpr double significant = 0.05;

/// Blue through white to red.
Colour diverging(double fraction)
{
    const double x = std::clamp(fraction, -1.0, 1.0);
    const double fade = 1.0 - std::abs(x);
    if (x >= 0.0) return {0.70 + 0.30 * fade, 0.09 + 0.91 * fade, 0.17 + 0.83 * fade};
    return {0.13 + 0.87 * fade, 0.40 + 0.60 * fade, 0.67 + 0.33 * fade};
}

struct Panel {
    std::string title;
    Eigen::VectorXd values;        ///< of the patches [m]
    std::vector<int> marked = {};  ///< patches of significant clusters
};

std::vector<int> marked_patches(const DiscrepancyMap& map)
{
    std::vector<int> marked;
    for (const Cluster& cluster : map.clusters) {
        if (cluster.p_family_wise < significant)
            marked.insert(marked.end(), cluster.patches.begin(), cluster.patches.end());
    }
    return marked;
}

std::vector<Panel> panels_of(const Diagnosis& diagnosis)
{
    std::vector<Panel> panels = {{"before", diagnosis.map.gap, marked_patches(diagnosis.map)}};
    if (diagnosis.map_after) {
        panels.push_back({"after", diagnosis.map_after->gap, marked_patches(*diagnosis.map_after)});
    }
    panels.push_back({"unexplained", diagnosis.explanation.unexplained});
    return panels;
}

/// Range of the colours: nearly all values of the first panel [m].
double colour_limit(const Eigen::VectorXd& values)
{
    std::vector<double> sizes;
    for (Eigen::Index i = 0; i < values.size(); ++i)
        sizes.push_back(std::abs(values[i]));
    std::sort(sizes.begin(), sizes.end());
    return std::max(
        0.02e-3, sizes[static_cast<std::size_t>(0.99 * (static_cast<double>(sizes.size()) - 1.0))]);
}

/// Draws the panels.
class Painter {
public:
    Painter(const Diagnosis& diagnosis, std::size_t num_panels, double limit)
        : field_(diagnosis.observations.field),
          from_(diagnosis.setting.from),
          to_(diagnosis.setting.to),
          limit_(limit),
          canvas_(left_margin + static_cast<double>(num_panels) * (map_width + gap) + right_margin,
                  top + map_height + bottom_margin)
    {
    }

    void draw(const Panel& panel, std::size_t place)
    {
        const double left = left_margin + static_cast<double>(place) * (map_width + gap);
        canvas_.begin_tiles({left, top, map_width, map_height});
        for (std::size_t i = 0; i < field_.patches.size(); ++i) {
            canvas_.fill(box_of(field_.patches[i], left),
                         diverging(panel.values[static_cast<Eigen::Index>(i)] / limit_));
        }
        canvas_.end_tiles();
        for (const int patch : panel.marked)
            canvas_.frame(box_of(field_.patches[static_cast<std::size_t>(patch)], left));
        canvas_.frame({left, top, map_width, map_height});
        canvas_.text(panel.title, {left + 0.5 * map_width, top - 24.0}, Align::centre, title_size);
        draw_axes(left, place == 0);
    }

    void draw_bar(std::size_t num_panels)
    {
        const double left = left_margin + static_cast<double>(num_panels) * (map_width + gap);
        canvas_.begin_tiles({left, top, bar_width, map_height});
        constexpr int num_bands = 280;
        for (int band = 0; band < num_bands; ++band) {
            canvas_.fill({left, top + map_height * band / num_bands, bar_width,
                          map_height / num_bands + 1.0},
                         diverging(1.0 - 2.0 * (band + 0.5) / num_bands));
        }
        canvas_.end_tiles();
        canvas_.frame({left, top, bar_width, map_height});
        for (const Tick& tick : axis_ticks(-1e3 * limit_, 1e3 * limit_, 8)) {
            const double y = top + 0.5 * map_height * (1.0 - tick.value / (1e3 * limit_));
            canvas_.line({left + bar_width, y}, {left + bar_width + 6.0, y});
            canvas_.text(tick.label, {left + bar_width + 12.0, y + 0.35 * font_size}, Align::left,
                         font_size);
        }
        canvas_.text("gap [mm]", {left, top - 12.0}, Align::left, font_size);
    }

    void save(const std::filesystem::path& path) const { canvas_.save(path); }

private:
    /// Distal is up.
    double height_of(double arc_length) const
    {
        return top + map_height * (to_ - arc_length) / (to_ - from_);
    }

    PictureBox box_of(const Patch& patch, double left) const
    {
        const double width = map_width / field_.options.around;
        const double upper = height_of(patch.arc_length + 0.5 * field_.options.length);
        const double lower = height_of(patch.arc_length - 0.5 * field_.options.length);
        return {left + width * patch.column, upper, width, lower - upper};
    }

    void draw_axes(double left, bool with_vertical_labels)
    {
        const double bottom = top + map_height;
        for (int degrees = 0; degrees <= 360; degrees += 90) {
            const double x = left + map_width * degrees / 360.0;
            canvas_.line({x, bottom}, {x, bottom + 6.0});
            canvas_.text(fmt::format("{}", degrees), {x, bottom + 24.0}, Align::centre, font_size);
        }
        canvas_.text("around [deg]", {left + 0.5 * map_width, bottom + 52.0}, Align::centre,
                     font_size);
        for (const Tick& tick : axis_ticks(1e3 * from_, 1e3 * to_, 9)) {
            const double y = height_of(1e-3 * tick.value);
            canvas_.line({left - 6.0, y}, {left, y});
            if (with_vertical_labels) {
                canvas_.text(tick.label, {left - 12.0, y + 0.35 * font_size}, Align::right,
                             font_size);
            }
        }
        if (with_vertical_labels) {
            canvas_.text("along the centerline [mm]", {left - 62.0, top + 0.5 * map_height},
                         Align::centre, font_size, -0.5 * std::numbers::pi);
        }
    }

    const DiscrepancyField& field_;
    double from_, to_, limit_;
    Canvas canvas_;
};

}  // namespace

void write_discrepancy_picture(const std::filesystem::path& path, const Diagnosis& diagnosis)
{
    const std::vector<Panel> panels = panels_of(diagnosis);
    Painter painter(diagnosis, panels.size(), colour_limit(panels.front().values));
    for (std::size_t i = 0; i < panels.size(); ++i)
        painter.draw(panels[i], i);
    painter.draw_bar(panels.size());
    painter.save(path);
}

}  // namespace braidzone

#include "export/law_picture.hpp"

#include "export/axis_ticks.hpp"
#include "export/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace braidzone {

namespace {

constexpr double font_size = 17.0;
constexpr double title_size = 21.0;
constexpr double picture_width = 1500.0;
constexpr double picture_height = 620.0;
constexpr double highest_velocity = 0.2;  // [m/s], of the plot

/// Colours that the colour-blind tell apart (Okabe and Ito 2008), the recommended law's first.
constexpr std::array<Colour, 8> colours{{{0.0, 0.0, 0.0},
                                         {0.0, 0.45, 0.70},
                                         {0.90, 0.62, 0.0},
                                         {0.0, 0.62, 0.45},
                                         {0.80, 0.47, 0.65},
                                         {0.35, 0.70, 0.90},
                                         {0.84, 0.37, 0.0},
                                         {0.6, 0.6, 0.6}}};

struct Curve {
    std::vector<Vec2> points;
    Colour colour{};
};

struct Axis {
    std::string title;
    double lower = 0.0;
    double upper = 1.0;
};

Curve loss_curve(const LawComparison& law, const Colour& colour)
{
    Curve curve{{}, colour};
    constexpr int num_points = 41;
    for (int i = 0; i < num_points; ++i) {
        const double velocity = highest_velocity * i / (num_points - 1);
        curve.points.emplace_back(1e3 * velocity, law.mean.linear + law.mean.quadratic * velocity);
    }
    return curve;
}

/// Mean of a in classes of the metal coverage.
Curve coverage_curve(const LawComparison& law, const ResistanceSheet& sheet, const Axis& coverage,
                     const Colour& colour)
{
    constexpr std::size_t num_classes = 30;
    std::array<double, num_classes> sums{}, coverages{};
    std::array<int, num_classes> counts{};
    const double width = (coverage.upper - coverage.lower) / num_classes;
    for (std::size_t i = 0; i < law.losses.size(); ++i) {
        const double value = sheet.surface.rhombi[i].metal_coverage;
        const auto place = static_cast<std::size_t>((value - coverage.lower) / width);
        const std::size_t bin = std::min(place, num_classes - 1);
        sums[bin] += law.losses[i].linear;
        coverages[bin] += value;
        ++counts[bin];
    }
    Curve curve{{}, colour};
    for (std::size_t bin = 0; bin < num_classes; ++bin) {
        if (counts[bin] > 0)
            curve.points.emplace_back(coverages[bin] / counts[bin], sums[bin] / counts[bin]);
    }
    return curve;
}

/// The range of coverages of the device, wide enough to be drawn.
Axis coverage_axis(const ResistanceSheet& sheet)
{
    Axis axis{"metal coverage", 1.0, 0.0};
    for (const Rhombus& rhombus : sheet.surface.rhombi) {
        axis.lower = std::min(axis.lower, rhombus.metal_coverage);
        axis.upper = std::max(axis.upper, rhombus.metal_coverage);
    }
    constexpr double smallest_span = 0.02;
    const double room = std::max(0.0, 0.5 * (smallest_span - (axis.upper - axis.lower)));
    axis.lower -= room;
    axis.upper += room;
    return axis;
}

double highest_of(const std::vector<Curve>& curves)
{
    double highest = 0.0;
    for (const Curve& curve : curves)
        for (const Vec2& point : curve.points)
            highest = std::max(highest, point[1]);
    return highest;
}

void draw_plot(Canvas& canvas, const PictureBox& box, const std::string& title,
               const Axis& horizontal, const Axis& vertical, const std::vector<Curve>& curves)
{
    const auto x_of = [&](double value) {
        return box.left +
               box.width * (value - horizontal.lower) / (horizontal.upper - horizontal.lower);
    };
    const auto y_of = [&](double value) {
        return box.bottom() -
               box.height * (value - vertical.lower) / (vertical.upper - vertical.lower);
    };
    for (const Curve& curve : curves) {
        std::vector<Vec2> pixels;
        for (const Vec2& point : curve.points)
            pixels.emplace_back(x_of(point[0]), y_of(point[1]));
        // A device of one density has one class only.
        if (pixels.size() == 1) pixels = {pixels[0] - Vec2(6.0, 0.0), pixels[0] + Vec2(6.0, 0.0)};
        canvas.curve(pixels, curve.colour, 3.0);
    }
    canvas.frame(box);
    canvas.text(title, {box.left + 0.5 * box.width, box.top - 18.0}, Align::centre, title_size);
    constexpr double tick_length = 6.0;
    for (const Tick& tick : axis_ticks(horizontal.lower, horizontal.upper, 7)) {
        const double x = x_of(tick.value);
        canvas.line({x, box.bottom()}, {x, box.bottom() + tick_length});
        canvas.text(tick.label, {x, box.bottom() + 28.0}, Align::centre, font_size);
    }
    canvas.text(horizontal.title, {box.left + 0.5 * box.width, box.bottom() + 60.0}, Align::centre,
                font_size);
    for (const Tick& tick : axis_ticks(vertical.lower, vertical.upper, 8)) {
        const double y = y_of(tick.value);
        canvas.line({box.left - tick_length, y}, {box.left, y});
        canvas.text(tick.label, {box.left - 12.0, y + 6.0}, Align::right, font_size);
    }
    canvas.text(vertical.title, {box.left - 78.0, box.top + 0.5 * box.height}, Align::centre,
                font_size, -0.5 * std::numbers::pi);
}

void draw_legend(Canvas& canvas, const std::vector<LawComparison>& laws, double left)
{
    double y = 90.0;
    canvas.text("a over the recommended law's", {left, y - 20.0}, Align::left, font_size);
    for (std::size_t i = 0; i < laws.size(); ++i) {
        y += 30.0;
        canvas.curve({{left, y - 6.0}, {left + 34.0, y - 6.0}}, colours[i % colours.size()], 3.0);
        canvas.text(laws[i].law, {left + 46.0, y}, Align::left, font_size);
        canvas.text(fmt::format("{:.2f}", laws[i].ratio), {left + 230.0, y}, Align::right,
                    font_size);
    }
}

}  // namespace

void write_law_picture(const std::filesystem::path& path, const ResistanceSheet& sheet,
                       const std::vector<LawComparison>& laws)
{
    const Axis coverage = coverage_axis(sheet);
    std::vector<Curve> of_velocity, of_coverage;
    // The recommended law is drawn last, on top.
    for (std::size_t i = laws.size(); i-- > 0;) {
        const Colour& colour = colours[i % colours.size()];
        of_velocity.push_back(loss_curve(laws[i], colour));
        of_coverage.push_back(coverage_curve(laws[i], sheet, coverage, colour));
    }
    constexpr double room = 1.05;
    Canvas canvas(picture_width, picture_height);
    draw_plot(canvas, {105.0, 60.0, 480.0, 470.0}, "pressure drop of the free part",
              {"velocity through the braid [mm/s]", 0.0, 1e3 * highest_velocity},
              {"pressure drop over velocity [Pa s/m]", 0.0, room * highest_of(of_velocity)},
              of_velocity);
    draw_plot(canvas, {700.0, 60.0, 480.0, 470.0}, "all rhombi of the device", coverage,
              {"linear part a [Pa s/m]", 0.0, room * highest_of(of_coverage)}, of_coverage);
    draw_legend(canvas, laws, 1215.0);
    canvas.save(path);
}

}  // namespace braidzone

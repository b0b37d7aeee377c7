#include "cli/curve_picture.hpp"

#include "export/axis_ticks.hpp"
#include "export/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace braidzone {
namespace {

constexpr double font_size = 17.0;
constexpr double title_size = 21.0;
constexpr double picture_width = 1400.0, picture_height = 620.0;
constexpr Colour measured_colour{0.0, 0.0, 0.0}, before_colour{0.84, 0.37, 0.0},
    after_colour{0.0, 0.45, 0.70}, floor_colour{0.85, 0.85, 0.85};

struct Range {
    double lower = 0.0, upper = 0.0;
};

/// A plot with its axes: from values to pixels.
class Plot {
public:
    Plot(Canvas& canvas, const PictureBox& box, const Range& x, const Range& y)
        : canvas_(canvas), box_(box), x_(x), y_(y)
    {
    }

    Vec2 at(double x, double y) const
    {
        return {box_.left + box_.width * (x - x_.lower) / (x_.upper - x_.lower),
                box_.bottom() - box_.height * (y - y_.lower) / (y_.upper - y_.lower)};
    }

    void curve(const std::vector<double>& x, const std::vector<double>& y, const Colour& colour)
    {
        std::vector<Vec2> pixels;
        for (std::size_t i = 0; i < x.size(); ++i)
            pixels.push_back(at(x[i], y[i]));
        canvas_.curve(pixels, colour, 3.0);
    }

    void points(const std::vector<double>& x, const std::vector<double>& y, const Colour& colour)
    {
        constexpr double half = 4.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Vec2 middle = at(x[i], y[i]);
            canvas_.fill({middle[0] - half, middle[1] - half, 2.0 * half, 2.0 * half}, colour);
        }
    }

    void axes(const std::string& title, const std::string& horizontal, const std::string& vertical)
    {
        canvas_.frame(box_);
        canvas_.text(title, {box_.left + 0.5 * box_.width, box_.top - 18.0}, Align::centre,
                     title_size);
        for (const Tick& tick : axis_ticks(x_.lower, x_.upper, 7)) {
            const double x = at(tick.value, y_.lower)[0];
            canvas_.line({x, box_.bottom()}, {x, box_.bottom() + 6.0});
            canvas_.text(tick.label, {x, box_.bottom() + 28.0}, Align::centre, font_size);
        }
        for (const Tick& tick : axis_ticks(y_.lower, y_.upper, 8)) {
            const double y = at(x_.lower, tick.value)[1];
            canvas_.line({box_.left - 6.0, y}, {box_.left, y});
            canvas_.text(tick.label, {box_.left - 12.0, y + 6.0}, Align::right, font_size);
        }
        canvas_.text(horizontal, {box_.left + 0.5 * box_.width, box_.bottom() + 60.0},
                     Align::centre, font_size);
        canvas_.text(vertical, {box_.left - 78.0, box_.top + 0.5 * box_.height}, Align::centre,
                     font_size, -0.5 * std::numbers::pi);
    }

private:
    Canvas& canvas_;
    PictureBox box_;
    Range x_, y_;
};

std::vector<double> over(const std::vector<double>& values, double unit)
{
    std::vector<double> result;
    for (const double value : values)
        result.push_back(value / unit);
    return result;
}

/// Measured minus simulated, over the simulated curve of the case as it is [%].
std::vector<double> gaps(const CurveDiagnosis& diagnosis, const std::vector<double>& simulated)
{
    std::vector<double> result;
    for (std::size_t i = 0; i < simulated.size(); ++i) {
        result.push_back(100.0 * (diagnosis.measured.ordinates[i] - simulated[i]) /
                         diagnosis.weights[i]);
    }
    return result;
}

Range range_of(const std::vector<std::vector<double>>& curves, bool symmetric)
{
    Range range;
    for (const std::vector<double>& curve : curves) {
        for (const double value : curve) {
            range.lower = std::min(range.lower, symmetric ? -std::abs(value) : value);
            range.upper = std::max(range.upper, symmetric ? std::abs(value) : value);
        }
    }
    constexpr double room = 1.05;
    return {room * range.lower, room * range.upper};
}

void draw_legend(Canvas& canvas, double left, bool has_effect)
{
    double y = 80.0;
    const auto entry = [&](const char* name, const Colour& colour) {
        canvas.curve({{left, y - 6.0}, {left + 34.0, y - 6.0}}, colour, 4.0);
        canvas.text(name, {left + 44.0, y}, Align::left, font_size);
        y += 28.0;
    };
    entry("measured", measured_colour);
    entry("before", before_colour);
    if (has_effect) entry("after", after_colour);
    entry("noise, 2 sd", floor_colour);
}

}  // namespace

void write_curve_picture(const std::filesystem::path& path, const CurveDiagnosis& diagnosis,
                         const CurveLabels& labels)
{
    const bool has_effect = diagnosis.explanation.best.has_value();
    const std::vector<double> x = over(diagnosis.measured.abscissae, labels.abscissa_si);
    const std::vector<double> measured = over(diagnosis.measured.ordinates, labels.ordinate_si);
    const std::vector<double> before = over(diagnosis.before, labels.ordinate_si);
    const std::vector<double> after = over(diagnosis.after, labels.ordinate_si);
    const Range across{std::min(0.0, x.front()), 1.02 * x.back()};
    const std::string horizontal = fmt::format("{} [{}]", labels.abscissa, labels.abscissa_unit);

    Canvas canvas(picture_width, picture_height);
    Plot left(canvas, {110.0, 60.0, 480.0, 470.0}, across,
              range_of({measured, before, after}, false));
    left.curve(x, before, before_colour);
    if (has_effect) left.curve(x, after, after_colour);
    left.points(x, measured, measured_colour);
    left.axes(labels.curve, horizontal,
              fmt::format("{} [{}]", labels.ordinate, labels.ordinate_unit));

    const std::vector<double> gap_before = gaps(diagnosis, diagnosis.before);
    const std::vector<double> gap_after = gaps(diagnosis, diagnosis.after);
    std::vector<double> above, below;
    for (std::size_t i = 0; i < x.size(); ++i) {
        above.push_back(200.0 * diagnosis.standard[i] / diagnosis.weights[i]);
        below.push_back(-above.back());
    }
    Plot right(canvas, {720.0, 60.0, 480.0, 470.0}, across,
               range_of({gap_before, gap_after, above}, true));
    std::vector<Vec2> band;
    for (std::size_t i = 0; i < x.size(); ++i)
        band.push_back(right.at(x[i], above[i]));
    for (std::size_t i = x.size(); i-- > 0;)
        band.push_back(right.at(x[i], below[i]));
    canvas.fill(band, floor_colour);
    right.curve(x, gap_before, before_colour);
    if (has_effect) right.curve(x, gap_after, after_colour);
    right.axes("measured minus simulated", horizontal, "over the simulated curve before [%]");
    draw_legend(canvas, 1220.0, has_effect);
    canvas.save(path);
}

}  // namespace braidzone

#include "export/foam_thin_layer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace braidzone {

namespace {

struct MeasuredLayer {
    double cells;
    std::array<double, 3> loss_factor;
    std::array<double, 3> error;
};

constexpr std::array<double, 3> uniform_layer = {3.0, 30.0, 300.0};
constexpr std::array<double, 3> cosine_layer = {2.0, 20.0, 200.0};
constexpr std::array<MeasuredLayer, 6> measured = {{
    {1.0, uniform_layer, {-0.27, -0.77, -0.97}},
    {2.0, uniform_layer, {-0.087, -0.24, -0.28}},
    {3.0, uniform_layer, {-0.041, -0.14, -0.20}},
    {4.0, cosine_layer, {-0.028, -0.093, -0.124}},
    {6.0, cosine_layer, {-0.010, -0.037, -0.056}},
    {8.0, cosine_layer, {-0.004, -0.019, -0.032}},
}};

double error_of(const MeasuredLayer& layer, double loss_factor)
{
    const auto& nodes = layer.loss_factor;
    const double k = std::clamp(loss_factor, nodes.front(), nodes.back());
    const std::size_t right = k > nodes[1] ? 2 : 1;
    const double t = std::log(k / nodes[right - 1]) / std::log(nodes[right] / nodes[right - 1]);
    return layer.error[right - 1] + t * (layer.error[right] - layer.error[right - 1]);
}

}  // namespace

double thin_layer_error(double cells_across, double loss_factor)
{
    const MeasuredLayer& finest = measured.back();
    if (cells_across >= finest.cells) {
        const double ratio = finest.cells / cells_across;
        return ratio * ratio * error_of(finest, loss_factor);
    }
    if (cells_across <= measured.front().cells) return error_of(measured.front(), loss_factor);
    const auto* right = std::find_if(measured.begin(), measured.end(),
                                     [&](const auto& layer) { return layer.cells > cells_across; });
    const auto* left = right - 1;
    const auto inverse_square = [](double n) { return 1.0 / (n * n); };
    const double t = (inverse_square(left->cells) - inverse_square(cells_across)) /
                     (inverse_square(left->cells) - inverse_square(right->cells));
    const double a = error_of(*left, loss_factor), b = error_of(*right, loss_factor);
    return a + t * (b - a);
}

}  // namespace braidzone

#include "discrepancy/imaging_chain.hpp"

#include "core/error.hpp"
#include "deploy/deployment_measures.hpp"
#include "deploy/node_normals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace braidzone {
namespace {

/// Deviations beyond which a neighbour's weight is nothing: exp(-8) = 3e-4.
constexpr double reach = 4.0;
/// The wall side of a bend is longer than its axis: hubs of rings whose nodes are within reach.
constexpr double hub_reach = 2.0 * reach;
constexpr int bisections = 60;

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// Variance of a mean over an edge, and of the linear interpolation along edges of a grid over the
/// orientations of a surface: the triangle's h^2 / 6 along an edge, seen along the surface's
/// normal, which has the mean square 1/2 among the edges that it cuts.
double voxel_variance(const ImagingChain& chain)
{
    return chain.voxel_size * chain.voxel_size / 12.0;
}

/// P(u, s), but for a factor 1/2.
double profile(double u, double deviation, double thickness)
{
    const double scale = 1.0 / (std::numbers::sqrt2 * deviation);
    return std::erf((u + 0.5 * thickness) * scale) - std::erf((u - 0.5 * thickness) * scale);
}

void require_length(double value, const char* key)
{
    if (!(value >= 0.0 && std::isfinite(value))) {
        throw ConfigError(
            fmt::format("measurement.{} = {:.6g} mm; it must not be negative (0: not known)", key,
                        1e3 * value));
    }
}

/// First and last ring whose hubs lie within a distance of that of a ring.
std::pair<int, int> rings_around(const std::vector<CrossSection>& rings, int ring, double distance)
{
    const auto is_near = [&](int other) {
        return other >= 0 && other < static_cast<int>(rings.size()) &&
               (rings[index(other)].origin - rings[index(ring)].origin).norm() < distance;
    };
    int first = ring, last = ring;
    while (is_near(first - 1))
        --first;
    while (is_near(last + 1))
        ++last;
    return {first, last};
}

}  // namespace

void validate(const ImagingChain& chain)
{
    require_length(chain.voxel_size, "voxel_size");
    require_length(chain.blur, "blur");
    if (!(chain.threshold > 0.0 && chain.threshold < 1.0)) {
        throw ConfigError(fmt::format(
            "measurement.threshold = {:.6g}; it must lie between 0 and 1, both excluded",
            chain.threshold));
    }
}

double blur_deviation(const ImagingChain& chain)
{
    return std::sqrt(chain.blur * chain.blur / (8.0 * std::numbers::ln2) + voxel_variance(chain));
}

double drawn_deviation(const ImagingChain& chain)
{
    const double blurred = blur_deviation(chain);
    return std::sqrt(blurred * blurred + voxel_variance(chain));
}

double apparent_half_thickness(const ImagingChain& chain, double thickness)
{
    const double drawn = drawn_deviation(chain);
    const double level = chain.threshold * profile(0.0, blur_deviation(chain), thickness);
    double inside = 0.0, outside = thickness + drawn;
    while (profile(outside, drawn, thickness) > level)
        outside *= 2.0;
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (inside + outside);
        (profile(middle, drawn, thickness) > level ? inside : outside) = middle;
    }
    return inside;
}

std::vector<double> blur_shifts(const Deployment& deployment, double deviation)
{
    const BraidLattice& lattice = deployment.lattice;
    const std::vector<Vec3>& nodes = deployment.nodes;
    const std::vector<Vec3> normals = node_normals(lattice, nodes);
    const std::vector<double> areas = node_areas(lattice, nodes);
    const double farthest = reach * deviation * reach * deviation;
    std::vector<double> shifts;
    shifts.reserve(nodes.size());
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const auto [first, last] = rings_around(deployment.rings, ring, hub_reach * deviation);
        const std::size_t begin = index(lattice.node(first, 0));
        const std::size_t end = index(lattice.node(last, 0)) + index(lattice.nodes_per_ring);
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const std::size_t node = index(lattice.node(ring, column));
            double sum = 0.0, weights = 0.0;
            for (std::size_t other = begin; other < end; ++other) {
                const Vec3 way = nodes[other] - nodes[node];
                const double square = way.squaredNorm();
                if (square > farthest) continue;
                const double weight =
                    areas[other] * std::exp(-0.5 * square / (deviation * deviation));
                sum += weight * way.dot(normals[node]);
                weights += weight;
            }
            shifts.push_back(weights > 0.0 ? sum / weights : 0.0);
        }
    }
    return shifts;
}

ImagedSheet imaged_sheet(const Deployment& deployment, double wire_diameter,
                         const ImagingChain& chain)
{
    ImagedSheet sheet{.middle = deployment.nodes};
    if (!chain.is_known()) return sheet;
    sheet.half_thickness = apparent_half_thickness(chain, 2.0 * wire_diameter);
    const std::vector<Vec3> normals = node_normals(deployment.lattice, deployment.nodes);
    const std::vector<double> shifts = blur_shifts(deployment, drawn_deviation(chain));
    for (std::size_t node = 0; node < shifts.size(); ++node)
        sheet.middle[node] += shifts[node] * normals[node];
    return sheet;
}

}  // namespace braidzone

// The whole chain by brute force: a sheet in voxels, blurred, its outer face contoured.

#include "deploy/node_normals.hpp"
#include "discrepancy/device_surface.hpp"
#include "support/straight_device.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace braidzone {
namespace {

constexpr double length = 4e-3;
constexpr double wire_diameter = 30e-6;

/// A braid of 2 mm that bulges by 0.3 mm to one side, as into a neck.
Deployment bulging_device()
{
    Deployment device = test::straight_device(2e-3, length, 41);
    for (Vec3& node : device.nodes) {
        const double along = std::exp(-0.5 * std::pow((node.z() - 0.5 * length) / 0.6e-3, 2));
        const double around = std::pow(0.5 + 0.5 * node.x() / 2e-3, 2);
        node.head<2>() *= 1.0 + 0.15 * along * around;
    }
    return device;
}

/// Grey values at the centres of voxels.
class Volume {
public:
    explicit Volume(double voxel) : voxel_(voxel), n_(static_cast<int>(std::ceil(6e-3 / voxel)))
    {
        values_.assign(static_cast<std::size_t>(n_) * n_ * n_, 0.0);
    }

    int size() const { return n_; }
    double& at(int i, int j, int k)
    {
        return values_[(static_cast<std::size_t>(k) * n_ + j) * n_ + i];
    }
    Vec3 centre(int i, int j, int k) const
    {
        return corner_ + voxel_ * Vec3(i + 0.5, j + 0.5, k + 0.5);
    }

    /// Adds a grain of material to the voxel in which it lies.
    void add(const Vec3& point, double volume)
    {
        const Vec3 place = (point - corner_) / voxel_;
        at(static_cast<int>(place.x()), static_cast<int>(place.y()), static_cast<int>(place.z())) +=
            volume / (voxel_ * voxel_ * voxel_);
    }

    /// By a Gaussian, along one axis after the other.
    void blur(double deviation)
    {
        const int reach = static_cast<int>(std::ceil(5.0 * deviation / voxel_));
        std::vector<double> weights;
        for (int i = -reach; i <= reach; ++i)
            weights.push_back(std::exp(-0.5 * std::pow(i * voxel_ / deviation, 2)));
        double sum = 0.0;
        for (const double weight : weights)
            sum += weight;
        const std::array<std::size_t, 3> strides = {1, static_cast<std::size_t>(n_),
                                                    static_cast<std::size_t>(n_) * n_};
        for (const std::size_t stride : strides) {
            std::vector<double> blurred(values_.size(), 0.0);
            for (std::size_t v = 0; v < values_.size(); ++v) {
                const int place = static_cast<int>(v / stride) % n_;
                for (int i = std::max(-reach, -place); i <= std::min(reach, n_ - 1 - place); ++i)
                    blurred[v] += weights[static_cast<std::size_t>(i + reach)] / sum *
                                  values_[v + static_cast<std::size_t>(i) * stride];
            }
            values_ = std::move(blurred);
        }
    }

private:
    double voxel_;
    int n_;
    Vec3 corner_ = Vec3(-3.013e-3, -2.991e-3, -1.007e-3);  // out of step with the braid
    std::vector<double> values_;
};

/// Fills the voxels with the sheet: grains on its triangles, in five layers.
void fill(Volume& volume, const Deployment& device)
{
    constexpr int cuts = 12, layers = 5;
    const std::vector<Vec3> normals = node_normals(device.lattice, device.nodes);
    for (const auto& corners : rhombus_triangles(device.lattice)) {
        const auto at = [&](const std::vector<Vec3>& values, std::size_t corner) {
            return values[static_cast<std::size_t>(corners[corner])];
        };
        const Vec3 a = at(device.nodes, 0), ab = at(device.nodes, 1) - a,
                   ac = at(device.nodes, 2) - a;
        const Vec3 normal = (at(normals, 0) + at(normals, 1) + at(normals, 2)).normalized();
        const double grain =
            0.5 * ab.cross(ac).norm() / (cuts * cuts) * 2.0 * wire_diameter / layers;
        for (int i = 0; i < cuts; ++i) {
            for (int j = 0; j < 2 * (cuts - i) - 1; ++j) {
                // Middles of the small triangles, upright ones and those between.
                const double shift = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
                const Vec3 point = a + (i + shift) / cuts * ab + (j / 2 + shift) / cuts * ac;
                for (int layer = 0; layer < layers; ++layer) {
                    const double off = ((layer + 0.5) / layers - 0.5) * 2.0 * wire_diameter;
                    volume.add(point + off * normal, grain);
                }
            }
        }
    }
}

/// Where the outer face cuts the edges between voxels, outside the middle and away from the ends.
std::vector<Vec3> outer_face(Volume& volume, const DeviceSurface& middle, double level)
{
    std::vector<Vec3> points;
    const int n = volume.size();
    for (int k = 1; k < n; ++k) {
        for (int j = 1; j < n; ++j) {
            for (int i = 1; i < n; ++i) {
                const double here = volume.at(i, j, k);
                const Vec3 at = volume.centre(i, j, k);
                for (const auto& [x, y, z] :
                     {std::array{1, 0, 0}, std::array{0, 1, 0}, std::array{0, 0, 1}}) {
                    const double before = volume.at(i - x, j - y, k - z);
                    if ((here > level) == (before > level)) continue;
                    const Vec3 from = volume.centre(i - x, j - y, k - z);
                    const Vec3 point = from + (level - before) / (here - before) * (at - from);
                    const bool is_inside = std::abs(point.z() - 0.5 * length) < 1.2e-3;
                    if (is_inside && middle.nearest(point).distance > 0.0) points.push_back(point);
                }
            }
        }
    }
    return points;
}

struct Gaps {
    double mean = 0.0, rms = 0.0;
};

Gaps gaps_to(const DeviceSurface& surface, const std::vector<Vec3>& points)
{
    Gaps gaps;
    const auto count = static_cast<double>(points.size());
    for (const Vec3& point : points) {
        const double distance = surface.nearest(point).distance;
        gaps.mean += distance / count;
        gaps.rms += distance * distance / count;
    }
    gaps.rms = std::sqrt(gaps.rms);
    return gaps;
}

}  // namespace

// Voxels and point spreads of C-arm CT. What is left is the unevenness of the rhombi and of the
// voxels; without the shift by the curvature the face would lie inside by s^2 / (2 R) on average,
// half as much again in front of the bulge.
TEST(ImagedVolume, ShowsTheDeviceWhereTheChainPutsIt)
{
    const Deployment device = bulging_device();
    const DeviceSurface middle(device);
    for (const ImagingChain& chain :
         {ImagingChain{.voxel_size = 0.1e-3, .blur = 0.4e-3, .threshold = 0.4},
          ImagingChain{.voxel_size = 0.2e-3, .blur = 0.4e-3, .threshold = 0.5}}) {
        Volume volume(chain.voxel_size);
        fill(volume, device);
        volume.blur(chain.blur / std::sqrt(8.0 * std::numbers::ln2));
        const double flat = std::erf(wire_diameter / (std::numbers::sqrt2 * blur_deviation(chain)));
        const std::vector<Vec3> points = outer_face(volume, middle, chain.threshold * flat);
        EXPECT_GT(points.size(), 500u);
        ImagedSheet sheet = imaged_sheet(device, wire_diameter, chain);
        const Gaps imaged = gaps_to(DeviceSurface(device, sheet), points);
        sheet.middle = device.nodes;
        const Gaps without_shift = gaps_to(DeviceSurface(device, sheet), points);
        EXPECT_LT(std::abs(imaged.mean), 0.02 * chain.voxel_size);
        EXPECT_LT(imaged.rms, 0.1 * chain.voxel_size);
        EXPECT_LT(without_shift.mean, imaged.mean - 5e-6);
    }
}

}  // namespace braidzone

#include "deploy/ring_planes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace braidzone {

namespace {

/// Of a constraint over that of a tangent: it is passed by the lag of the rings on one side of it,
/// summed, over this, 5e-5 for a bend of 180 degrees.
constexpr double penalty = 1e5;
/// Step of a normal that ends the iteration [rad].
constexpr double tolerance = 1e-9;
constexpr int most_rounds = 100;
constexpr int most_halvings = 30;

/// Over the nominal radius: of the mean direction of a bend, and of the reach.
constexpr double direction_smoothing = 0.5, reach_smoothing = 0.25;
/// Directions about the inside of a bend in which the lumen's extent is looked for.
constexpr int num_directions = 7;
constexpr double direction_step = std::numbers::pi / 9.0;

using Coordinates = Eigen::Matrix<double, 3, 2>;

/// The planes' normals on their way to the best.
class Normals {
public:
    Normals(const std::vector<CrossSection>& rings, const std::vector<double>& reaches,
            const std::vector<double>& least_gaps)
        : rings_(rings), reaches_(reaches), least_gaps_(least_gaps)
    {
        for (const CrossSection& ring : rings)
            normals_.push_back(ring.tangent);
    }

    const std::vector<Vec3>& values() const { return normals_; }

    bool is_any_crossed() const
    {
        for (std::size_t gap = 0; gap < reaches_.size(); ++gap) {
            if (excess(normals_, gap) > 0.0) return true;
        }
        return false;
    }

    /// Newton's step of each normal in its tangent plane; its length.
    double take_step()
    {
        const std::vector<Vec3> steps = newton_steps();
        double longest = 0.0;
        for (const Vec3& step : steps)
            longest = std::max(longest, step.norm());
        const double before = energy(normals_);
        double share = 1.0;
        for (int halving = 0; halving < most_halvings; ++halving, share *= 0.5) {
            std::vector<Vec3> moved;
            for (std::size_t k = 0; k < normals_.size(); ++k)
                moved.push_back((normals_[k] + share * steps[k]).normalized());
            if (!(energy(moved) <= before) && halving + 1 < most_halvings) continue;
            normals_ = std::move(moved);
            break;
        }
        return share * longest;
    }

private:
    Vec3 hub_step(std::size_t gap) const { return rings_[gap].origin - rings_[gap + 1].origin; }

    /// By how much two normals turn more than they may.
    double excess(const std::vector<Vec3>& normals, std::size_t gap) const
    {
        return (normals[gap] - normals[gap + 1]).norm() - allowed(normals, gap);
    }

    double allowed(const std::vector<Vec3>& normals, std::size_t gap) const
    {
        const double spacing = 0.5 * hub_step(gap).dot(normals[gap] + normals[gap + 1]);
        return std::max(0.0, spacing - least_gaps_[gap]) / reaches_[gap];
    }

    double energy(const std::vector<Vec3>& normals) const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < normals.size(); ++k)
            sum += 0.5 * (normals[k] - rings_[k].tangent).squaredNorm();
        for (std::size_t gap = 0; gap < reaches_.size(); ++gap)
            sum += 0.5 * penalty * std::pow(std::max(0.0, excess(normals, gap)), 2);
        return sum;
    }

    /// Gauss and Newton's matrix, with the tension across a turn; two rows for each normal.
    std::vector<Vec3> newton_steps() const
    {
        const std::size_t n = normals_.size();
        std::vector<Coordinates> bases;
        std::vector<Eigen::Matrix2d> diagonal;
        std::vector<Eigen::Matrix2d> above(n, Eigen::Matrix2d::Zero());  // block (k, k + 1)
        std::vector<Vec2> right;
        for (std::size_t k = 0; k < n; ++k) {
            Coordinates basis;
            basis.col(0) = normals_[k].unitOrthogonal();
            basis.col(1) = normals_[k].cross(Vec3(basis.col(0)));
            bases.push_back(basis);
            diagonal.push_back(std::max(0.1, normals_[k].dot(rings_[k].tangent)) *
                               Eigen::Matrix2d::Identity());
            right.push_back(basis.transpose() * rings_[k].tangent);
        }
        for (std::size_t gap = 0; gap + 1 < n; ++gap) {
            const double beyond = excess(normals_, gap);
            if (!(beyond > 0.0)) continue;
            const Vec3 turn = normals_[gap] - normals_[gap + 1];
            const double angle = turn.norm();
            const Vec3 along = turn / angle;
            const Vec3 room = allowed(normals_, gap) > 0.0
                                  ? Vec3(0.5 / reaches_[gap] * hub_step(gap))
                                  : Vec3(Vec3::Zero());
            const Vec2 first = bases[gap].transpose() * (along - room);
            const Vec2 second = bases[gap + 1].transpose() * (-along - room);
            const Eigen::Matrix3d across =
                beyond / angle * (Eigen::Matrix3d::Identity() - along * along.transpose());
            diagonal[gap] += penalty * (first * first.transpose() +
                                        bases[gap].transpose() * across * bases[gap]);
            diagonal[gap + 1] += penalty * (second * second.transpose() +
                                            bases[gap + 1].transpose() * across * bases[gap + 1]);
            above[gap] += penalty * (first * second.transpose() -
                                     bases[gap].transpose() * across * bases[gap + 1]);
            right[gap] -= penalty * beyond * first;
            right[gap + 1] -= penalty * beyond * second;
        }
        for (std::size_t k = 1; k < n; ++k) {
            const Eigen::Matrix2d ratio = diagonal[k - 1].ldlt().solve(above[k - 1]).transpose();
            diagonal[k] -= ratio * above[k - 1];
            right[k] -= ratio * right[k - 1];
        }
        std::vector<Vec3> steps(n);
        Vec2 next = Vec2::Zero();
        for (std::size_t k = n; k-- > 0;) {
            next = diagonal[k].ldlt().solve(Vec2(right[k] - above[k] * next));
            steps[k] = bases[k] * next;
        }
        return steps;
    }

    const std::vector<CrossSection>& rings_;
    const std::vector<double>& reaches_;
    const std::vector<double>& least_gaps_;
    std::vector<Vec3> normals_;
};

/// Means of values between rings, weighted by a Gaussian of their distance along the hubs.
template <typename Value>
std::vector<Value> smoothed(const std::vector<Value>& values, const std::vector<double>& places,
                            double width, const Value& zero)
{
    std::vector<Value> means;
    for (const double place : places) {
        Value sum = zero;
        double weights = 0.0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double u = (places[i] - place) / width;
            const double weight = std::exp(-0.5 * u * u);
            sum += weight * values[i];
            weights += weight;
        }
        means.push_back(sum / weights);
    }
    return means;
}

/// Extent of the lumen in a direction, by rays around it in the ring's plane [m].
double extent_towards(const CrossSection& ring, const Vec3& towards, const WallTree& wall,
                      double nominal_radius)
{
    const Vec3 aside = ring.tangent.cross(towards);
    double extent = 0.0;
    for (int i = 0; i < num_directions; ++i) {
        const double angle = direction_step * (i - num_directions / 2);
        const Vec3 ray = std::cos(angle) * towards + std::sin(angle) * aside;
        const auto hit = wall.first_hit(ring.origin, ring.origin + nominal_radius * ray);
        extent = std::max(extent, (hit ? hit->fraction : 1.0) * nominal_radius * std::cos(angle));
    }
    return extent;
}

/// A ring turned about its hub by the least rotation that gives it a normal.
CrossSection turned(const CrossSection& ring, const Vec3& normal)
{
    const auto turn = Eigen::Quaterniond::FromTwoVectors(ring.tangent, normal);
    CrossSection result = ring;
    result.tangent = normal;
    result.normal = turn * ring.normal;
    result.normal = (result.normal - result.normal.dot(normal) * normal).normalized();
    result.binormal = normal.cross(result.normal);
    return result;
}

}  // namespace

std::vector<Vec3> uncrossed_normals(const std::vector<CrossSection>& rings,
                                    const std::vector<double>& reaches,
                                    const std::vector<double>& least_gaps)
{
    Normals normals(rings, reaches, least_gaps);
    if (!normals.is_any_crossed()) return normals.values();
    for (int round = 0; round < most_rounds; ++round) {
        if (normals.take_step() <= tolerance) break;
    }
    return normals.values();
}

std::vector<double> inner_reaches(const std::vector<CrossSection>& rings, const WallTree& wall,
                                  double nominal_radius)
{
    std::vector<Vec3> turns;
    std::vector<double> places;
    double place = 0.0;
    for (std::size_t gap = 0; gap + 1 < rings.size(); ++gap) {
        const double step = (rings[gap].origin - rings[gap + 1].origin).norm();
        turns.push_back(rings[gap].tangent - rings[gap + 1].tangent);
        places.push_back(place + 0.5 * step);
        place += step;
    }
    const std::vector<Vec3> towards =
        smoothed(turns, places, direction_smoothing * nominal_radius, Vec3(Vec3::Zero()));
    std::vector<double> reaches;
    for (std::size_t gap = 0; gap + 1 < rings.size(); ++gap) {
        const CrossSection& ring = rings[gap];
        const Vec3 inner = towards[gap] - towards[gap].dot(ring.tangent) * ring.tangent;
        const double size = inner.norm();
        reaches.push_back(size > 0.0 ? extent_towards(ring, inner / size, wall, nominal_radius)
                                     : nominal_radius);
    }
    return smoothed(reaches, places, reach_smoothing * nominal_radius, 0.0);
}

std::vector<CrossSection> uncrossed_rings(std::vector<CrossSection> rings, const WallTree& wall,
                                          double nominal_radius,
                                          const std::vector<double>& least_gaps)
{
    const std::vector<double> furthest(least_gaps.size(), nominal_radius);
    if (!Normals(rings, furthest, least_gaps).is_any_crossed()) return rings;
    const std::vector<Vec3> normals =
        uncrossed_normals(rings, inner_reaches(rings, wall, nominal_radius), least_gaps);
    for (std::size_t k = 0; k < rings.size(); ++k) {
        if (normals[k] != rings[k].tangent) rings[k] = turned(rings[k], normals[k]);
    }
    return rings;
}

}  // namespace braidzone

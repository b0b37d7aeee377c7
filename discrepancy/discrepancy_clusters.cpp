#include "discrepancy/discrepancy_clusters.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace braidzone {
namespace {

std::size_t index(int i)
{
    return static_cast<std::size_t>(i);
}

/// For each patch, the patches beside it, also across a corner.
std::vector<std::vector<int>> neighbours(const DiscrepancyField& field)
{
    const auto count = static_cast<int>(field.patches.size());
    const int around = field.options.around;
    std::vector<std::vector<int>> all(index(count));
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            const Patch &a = field.patches[index(i)], &b = field.patches[index(j)];
            const int turn = std::abs(a.column - b.column);
            if (i != j && std::abs(a.row - b.row) <= 1 && std::min(turn, around - turn) <= 1)
                all[index(i)].push_back(j);
        }
    }
    return all;
}

/// Sets of neighbouring patches with t beyond the threshold on the same side.
std::vector<std::vector<int>> connected(const Eigen::VectorXd& t, double threshold,
                                        const std::vector<std::vector<int>>& beside)
{
    std::vector<char> seen(beside.size(), 0);
    std::vector<std::vector<int>> sets;
    const auto belongs = [&](int i, bool positive) {
        return std::abs(t[i]) > threshold && (t[i] > 0.0) == positive;
    };
    for (int start = 0; start < static_cast<int>(beside.size()); ++start) {
        const bool positive = t[start] > 0.0;
        if (seen[index(start)] || !belongs(start, positive)) continue;
        std::vector<int> set = {start};
        seen[index(start)] = 1;
        for (std::size_t next = 0; next < set.size(); ++next) {
            for (const int other : beside[index(set[next])]) {
                if (seen[index(other)] || !belongs(other, positive)) continue;
                seen[index(other)] = 1;
                set.push_back(other);
            }
        }
        std::sort(set.begin(), set.end());
        sets.push_back(std::move(set));
    }
    return sets;
}

double mass_of(const std::vector<int>& set, const Eigen::VectorXd& t)
{
    double mass = 0.0;
    for (const int patch : set)
        mass += std::abs(t[patch]);
    return mass;
}

double peak_of(const std::vector<int>& set, const Eigen::VectorXd& t)
{
    double peak = 0.0;
    for (const int patch : set)
        peak = std::max(peak, std::abs(t[patch]));
    return peak;
}

/// Largest cluster mass and largest |t| of each map drawn without an effect, increasing.
struct NullMaps {
    std::vector<double> masses, peaks;
};

NullMaps null_maps(const Eigen::MatrixXd& standardising, const Eigen::MatrixXd& factor,
                   const std::vector<std::vector<int>>& beside, const ClusterOptions& options)
{
    const Eigen::MatrixXd map_of_noise = standardising * factor;
    std::mt19937 random(options.seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd noise(map_of_noise.cols());
    NullMaps maps;
    for (int draw = 0; draw < options.num_draws; ++draw) {
        for (Eigen::Index i = 0; i < noise.size(); ++i)
            noise[i] = normal(random);
        const Eigen::VectorXd t = map_of_noise * noise;
        double largest = 0.0;
        for (const auto& set : connected(t, options.threshold, beside))
            largest = std::max(largest, mass_of(set, t));
        maps.masses.push_back(largest);
        maps.peaks.push_back(t.cwiseAbs().maxCoeff());
    }
    std::sort(maps.masses.begin(), maps.masses.end());
    std::sort(maps.peaks.begin(), maps.peaks.end());
    return maps;
}

/// Share of values that reach a value, itself counted in.
double share_reaching(const std::vector<double>& sorted, double value)
{
    const auto above = sorted.end() - std::lower_bound(sorted.begin(), sorted.end(), value);
    return (1.0 + static_cast<double>(above)) / (1.0 + static_cast<double>(sorted.size()));
}

Cluster describe(const std::vector<int>& set, const DiscrepancyField& field,
                 const DiscrepancyMap& map)
{
    Cluster cluster{.patches = set, .mass = mass_of(set, map.t)};
    cluster.from = field.patches[index(set.front())].arc_length;
    cluster.to = cluster.from;
    std::complex<double> direction = 0.0;
    double weights = 0.0;
    for (const int i : set) {
        const Patch& patch = field.patches[index(i)];
        const double weight = patch.area * std::abs(map.smoothed[i]);
        cluster.area += patch.area;
        cluster.from = std::min(cluster.from, patch.arc_length);
        cluster.to = std::max(cluster.to, patch.arc_length);
        cluster.mean_gap += patch.area * map.gap[i];
        cluster.contact_share += patch.area * patch.contact_share;
        cluster.arc_length += weight * patch.arc_length;
        direction += std::polar(weight, patch.angle);
        weights += weight;
        if (std::abs(map.smoothed[i]) > std::abs(cluster.largest_gap))
            cluster.largest_gap = map.smoothed[i];
    }
    cluster.from -= 0.5 * field.options.length;
    cluster.to += 0.5 * field.options.length;
    cluster.mean_gap /= cluster.area;
    cluster.contact_share /= cluster.area;
    cluster.arc_length /= weights;
    cluster.angle = std::arg(direction);
    if (cluster.angle < 0.0) cluster.angle += 2.0 * std::numbers::pi;
    return cluster;
}

}  // namespace

Eigen::MatrixXd smoothing_matrix(const DiscrepancyField& field, double kernel)
{
    Eigen::MatrixXd weights =
        (-0.5 * (patch_distances(field) / kernel).array().square()).exp().matrix();
    for (Eigen::Index i = 0; i < weights.rows(); ++i)
        weights.row(i) /= weights.row(i).sum();
    return weights;
}

DiscrepancyMap make_discrepancy_map(const DiscrepancyField& field, const ErrorModel& error,
                                    const Eigen::VectorXd& gaps, const ClusterOptions& options)
{
    const Eigen::Index n = error.num_patches;
    const Eigen::LLT<Eigen::MatrixXd> factor(error.without_registration().topLeftCorner(n, n));
    const Eigen::MatrixXd motion = error.motion.topRows(n);
    const Eigen::MatrixXd solved = factor.solve(motion);
    const Eigen::MatrixXd registering =
        Eigen::MatrixXd::Identity(n, n) -
        motion * (motion.transpose() * solved).ldlt().solve(solved.transpose());
    const Eigen::MatrixXd smoothing = smoothing_matrix(field, options.kernel) * registering;
    const Eigen::MatrixXd lower = factor.matrixL();
    const Eigen::VectorXd sd = (smoothing * lower).rowwise().norm();

    DiscrepancyMap map;
    map.gap = registering * gaps;
    map.smoothed = smoothing * gaps;
    map.t = map.smoothed.cwiseQuotient(sd);
    const auto beside = neighbours(field);
    const NullMaps null =
        null_maps(sd.cwiseInverse().asDiagonal() * smoothing, lower, beside, options);
    for (const auto& set : connected(map.t, options.threshold, beside)) {
        Cluster cluster = describe(set, field, map);
        cluster.p_family_wise =
            std::min(1.0, 2.0 * std::min(share_reaching(null.masses, cluster.mass),
                                         share_reaching(null.peaks, peak_of(set, map.t))));
        map.clusters.push_back(std::move(cluster));
    }
    std::stable_sort(
        map.clusters.begin(), map.clusters.end(),
        [](const Cluster& a, const Cluster& b) { return a.p_family_wise < b.p_family_wise; });
    return map;
}

}  // namespace braidzone

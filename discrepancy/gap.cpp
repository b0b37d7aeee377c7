#include "discrepancy/gap.hpp"

#include "discrepancy/discrepancy_field.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <random>

namespace braidzone {
namespace {

constexpr int num_draws = 200;

}  // namespace

Eigen::VectorXd registered_gap(const ErrorModel& error, const Eigen::VectorXd& residuals)
{
    const Eigen::VectorXd solved = error.covariance().llt().solve(residuals);
    const Eigen::VectorXd motion =
        error.motion * (error.motion_variance.asDiagonal() * (error.motion.transpose() * solved));
    return (residuals - motion).head(error.num_patches);
}

GapFigures gap_figures(const Eigen::VectorXd& gap, const Eigen::MatrixXd& smoothing,
                       const std::vector<int>& patches)
{
    GapFigures figures;
    if (patches.empty()) return figures;
    std::vector<double> sizes;
    double squares = 0.0;
    for (const int patch : patches) {
        squares += gap[patch] * gap[patch];
        sizes.push_back(std::abs(gap[patch]));
        figures.largest_smoothed =
            std::max(figures.largest_smoothed, std::abs(smoothing.row(patch).dot(gap)));
    }
    figures.rms = std::sqrt(squares / static_cast<double>(sizes.size()));
    std::sort(sizes.begin(), sizes.end());
    const double place = 0.95 * static_cast<double>(sizes.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    figures.percentile_95 = std::lerp(sizes[below], sizes[std::min(below + 1, sizes.size() - 1)],
                                      place - static_cast<double>(below));
    return figures;
}

GapComparison compare_gaps(const ErrorModel& error, const Eigen::MatrixXd& smoothing,
                           const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                           const std::vector<int>& patches, std::uint32_t seed)
{
    GapComparison result;
    result.num_patches = static_cast<int>(patches.size());
    result.before = gap_figures(registered_gap(error, before), smoothing, patches);
    result.after = gap_figures(registered_gap(error, after), smoothing, patches);
    if (patches.empty()) return result;

    const Eigen::LLT<Eigen::MatrixXd> factor(error.covariance());
    const Eigen::MatrixXd lower = factor.matrixL();
    const Eigen::MatrixXd motion = error.motion * error.motion_variance.asDiagonal();
    const Eigen::MatrixXd taking = factor.solve(error.motion).transpose();
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> rms, percentile_95, largest;
    Eigen::VectorXd noise(lower.rows());
    for (int draw = 0; draw < num_draws; ++draw) {
        for (Eigen::Index i = 0; i < noise.size(); ++i)
            noise[i] = normal(random);
        const Eigen::VectorXd residuals = lower * noise;
        const Eigen::VectorXd gap =
            (residuals - motion * (taking * residuals)).head(error.num_patches);
        const GapFigures figures = gap_figures(gap, smoothing, patches);
        rms.push_back(figures.rms);
        percentile_95.push_back(figures.percentile_95);
        largest.push_back(figures.largest_smoothed);
    }
    result.floor = {median_of(rms), median_of(percentile_95), median_of(largest)};
    return result;
}

}  // namespace braidzone

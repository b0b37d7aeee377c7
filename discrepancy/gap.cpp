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

double closure(const GapComparison& gaps)
{
    const auto square = [](const GapFigures& figures) { return figures.rms * figures.rms; };
    return (square(gaps.before) - square(gaps.after)) / (square(gaps.before) - square(gaps.floor));
}

Eigen::MatrixXd registration_taken_out(const ErrorModel& error)
{
    const Eigen::Index n = error.num_patches;
    const Eigen::MatrixXd solved = error.covariance().llt().solve(error.motion);
    Eigen::MatrixXd taking =
        -error.motion.topRows(n) * error.motion_variance.asDiagonal() * solved.transpose();
    taking.leftCols(n).diagonal().array() += 1.0;
    return taking;
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

GapFigures floor_figures(const Eigen::MatrixXd& taking, const Eigen::MatrixXd& covariance,
                         const Eigen::MatrixXd& smoothing, const std::vector<int>& patches,
                         std::uint32_t seed)
{
    if (patches.empty()) return {};
    const Eigen::MatrixXd drawing = taking * Eigen::MatrixXd(covariance.llt().matrixL());
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> rms, percentile_95, largest;
    Eigen::VectorXd noise(drawing.cols());
    for (int draw = 0; draw < num_draws; ++draw) {
        for (Eigen::Index i = 0; i < noise.size(); ++i)
            noise[i] = normal(random);
        const GapFigures figures = gap_figures(drawing * noise, smoothing, patches);
        rms.push_back(figures.rms);
        percentile_95.push_back(figures.percentile_95);
        largest.push_back(figures.largest_smoothed);
    }
    return {median_of(rms), median_of(percentile_95), median_of(largest)};
}

}  // namespace braidzone

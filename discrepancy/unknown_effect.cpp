#include "discrepancy/unknown_effect.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace braidzone {
namespace {

constexpr std::array<double, 4> amplitudes = {0.04e-3, 0.08e-3, 0.16e-3, 0.32e-3};  // [m]
constexpr std::array<double, 3> lengths = {1e-3, 2e-3, 4e-3};                       // [m]

}  // namespace

UnknownEffect::UnknownEffect(const DiscrepancyField& field, const Whitening& whitening,
                             Eigen::Index num_residuals)
    : whitening_(whitening), num_patches_(static_cast<Eigen::Index>(field.patches.size()))
{
    const Eigen::MatrixXd distances = patch_distances(field);
    for (const double length : lengths) {
        Scale scale;
        scale.kernel = Eigen::MatrixXd::Zero(num_residuals, num_residuals);
        scale.kernel.topLeftCorner(num_patches_, num_patches_) =
            (-0.5 * (distances / length).array().square()).exp();
        const Eigen::MatrixXd half = whitening.of_columns(scale.kernel);
        const Eigen::MatrixXd whole = whitening.of_columns(half.transpose());
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 *
                                                                    (whole + whole.transpose()));
        scale.vectors = solver.eigenvectors();
        scale.eigenvalues = solver.eigenvalues().cwiseMax(0.0);
        scales_.push_back(std::move(scale));
    }
}

double UnknownEffect::log_evidence(const Scale& scale, double amplitude,
                                   const Eigen::VectorXd& along)
{
    const Eigen::ArrayXd d = amplitude * amplitude * scale.eigenvalues.array();
    return (-0.5 * d.log1p() + 0.5 * along.array().square() * d / (1.0 + d)).sum();
}

double UnknownEffect::log_evidence(const Eigen::VectorXd& whitened) const
{
    std::vector<double> logs;
    for (const Scale& scale : scales_) {
        const Eigen::VectorXd along = scale.vectors.transpose() * whitened;
        for (const double amplitude : amplitudes)
            logs.push_back(log_evidence(scale, amplitude, along));
    }
    const double largest = *std::max_element(logs.begin(), logs.end());
    double sum = 0.0;
    for (const double value : logs)
        sum += std::exp(value - largest);
    return largest + std::log(sum / static_cast<double>(logs.size()));
}

Eigen::VectorXd UnknownEffect::mean_field(const Eigen::VectorXd& whitened) const
{
    double best = -1e300;
    Eigen::VectorXd field;
    for (const Scale& scale : scales_) {
        const Eigen::VectorXd along = scale.vectors.transpose() * whitened;
        for (const double amplitude : amplitudes) {
            const double evidence = log_evidence(scale, amplitude, along);
            if (evidence <= best) continue;
            best = evidence;
            // K C^-1/2' (I + a^2 D)^-1 u, with K = a^2 kernel and L^-1 K = of_columns(K)
            const double square = amplitude * amplitude;
            const Eigen::VectorXd solved =
                scale.vectors *
                (along.array() / (1.0 + square * scale.eigenvalues.array())).matrix();
            field = square * whitening_.of_columns(scale.kernel).transpose() * solved;
        }
    }
    return field.head(num_patches_);
}

}  // namespace braidzone

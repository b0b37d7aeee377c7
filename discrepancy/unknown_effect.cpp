#include "discrepancy/unknown_effect.hpp"

#include "discrepancy/laplace_evidence.hpp"

#include <Eigen/Dense>

namespace braidzone {

UnknownEffect::UnknownEffect(const DiagnosisProblem& problem, const Whitening& whitening)
    : amplitudes_(problem.unknown_amplitudes),
      whitening_(whitening),
      field_size_(problem.distances.rows())
{
    const Eigen::Index num_residuals = problem.covariance.rows();
    for (const double length : problem.unknown_lengths) {
        Scale scale;
        scale.kernel = Eigen::MatrixXd::Zero(num_residuals, num_residuals);
        scale.kernel.topLeftCorner(field_size_, field_size_) =
            (-0.5 * (problem.distances / length).array().square()).exp();
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
        for (const double amplitude : amplitudes_)
            logs.push_back(log_evidence(scale, amplitude, along));
    }
    return log_of_mean(logs);
}

Eigen::VectorXd UnknownEffect::mean_field(const Eigen::VectorXd& whitened) const
{
    double best = -1e300;
    Eigen::VectorXd field;
    for (const Scale& scale : scales_) {
        const Eigen::VectorXd along = scale.vectors.transpose() * whitened;
        for (const double amplitude : amplitudes_) {
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
    return field.head(field_size_);
}

}  // namespace braidzone

#include "discrepancy/artefacts.hpp"

#include "discrepancy/error_model.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

constexpr double artefact_bar = 5.0;  // standard deviations: 1e-4 of 270 patches with normal errors
constexpr double smooth_sd = 0.16e-3;
constexpr double smooth_length = 1e-3;

}  // namespace

std::vector<int> outlying_values(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& values,
                                 double bar)
{
    const Eigen::Index n = values.size();
    Eigen::MatrixXd precision =
        covariance.llt().solve(Eigen::MatrixXd::Identity(n, n)).selfadjointView<Eigen::Lower>();
    std::vector<int> left_out;
    Eigen::VectorXd kept = Eigen::VectorXd::Ones(n);
    while (static_cast<Eigen::Index>(left_out.size()) + 1 < n) {
        const Eigen::VectorXd off = precision * values.cwiseProduct(kept);
        Eigen::Index furthest = 0;
        const double most =
            (kept.array() > 0.0)
                .select(off.array().abs() / precision.diagonal().array().sqrt(), 0.0)
                .maxCoeff(&furthest);
        if (!(most > bar)) break;
        left_out.push_back(static_cast<int>(furthest));
        kept[furthest] = 0.0;
        // Of the inverse of the covariance without that row and column.
        const Eigen::VectorXd column = precision.col(furthest);
        precision -= column * column.transpose() / column[furthest];
        precision(furthest, furthest) = 1.0;
    }
    return left_out;
}

std::vector<Patch> leave_out_artefacts(Observations& observations, const Eigen::VectorXd& residuals,
                                       const NoiseFloor& floor)
{
    const ErrorModel error = make_error_model(observations, floor);
    const Eigen::Index n = error.num_patches;
    const Eigen::ArrayXXd distances = patch_distances(observations.field).array();
    const Eigen::MatrixXd smooth =
        std::pow(smooth_sd, 2) * (-0.5 * (distances / smooth_length).square()).exp().matrix();
    const std::vector<int> outlying = outlying_values(
        error.covariance().topLeftCorner(n, n) + smooth, residuals.head(n), artefact_bar);
    std::vector<Patch> artefacts, kept;
    std::vector<Patch>& patches = observations.field.patches;
    for (int i = 0; i < static_cast<int>(patches.size()); ++i) {
        const bool is_kept = std::find(outlying.begin(), outlying.end(), i) == outlying.end();
        (is_kept ? kept : artefacts).push_back(std::move(patches[static_cast<std::size_t>(i)]));
    }
    patches = std::move(kept);
    return artefacts;
}

}  // namespace braidzone

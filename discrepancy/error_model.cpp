#include "discrepancy/error_model.hpp"

#include "discrepancy/channel_errors.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace braidzone {
namespace {

double square(double x)
{
    return x * x;
}

/// Of the weighted mean of a patch's distances [m^2].
double variance_of_gap(const Patch& patch)
{
    double squares = 0.0;
    for (const double weight : patch.weights)
        squares += square(weight);
    return square(patch.point_sd) * squares;
}

Eigen::VectorXd hub_slopes(const std::vector<Patch>& patches)
{
    Eigen::VectorXd slopes(static_cast<Eigen::Index>(patches.size()));
    for (Eigen::Index i = 0; i < slopes.size(); ++i)
        slopes[i] = patches[static_cast<std::size_t>(i)].hub_slope;
    return slopes;
}

/// Covariance of distal end, proximal end and length between background deployments.
Eigen::Matrix3d end_background(const NoiseFloor& floor)
{
    // proximal = distal - length
    Eigen::Matrix<double, 3, 2> by;  // landing, length
    by << 1.0, 0.0, 1.0, -1.0, 0.0, 1.0;
    const Eigen::Vector2d variance(square(floor.landing_sd), square(floor.length_sd));
    return by * variance.asDiagonal() * by.transpose();
}

}  // namespace

Eigen::MatrixXd patch_distances(const DiscrepancyField& field)
{
    const auto n = static_cast<Eigen::Index>(field.patches.size());
    Eigen::MatrixXd distances(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            distances(i, j) = (field.patches[static_cast<std::size_t>(i)].centre -
                               field.patches[static_cast<std::size_t>(j)].centre)
                                  .norm();
        }
    }
    return distances;
}

ErrorModel make_error_model(const Observations& observations, const NoiseFloor& floor)
{
    const auto& patches = observations.field.patches;
    const auto n = static_cast<Eigen::Index>(patches.size());
    const Eigen::Index all = num_residuals(observations);
    ErrorModel model;
    model.num_patches = n;
    model.white = Eigen::VectorXd::Zero(all);
    model.background = Eigen::MatrixXd::Zero(all, all);
    model.motion = Eigen::MatrixXd::Zero(all, 6);
    model.motion_variance.resize(6);
    model.motion_variance << Eigen::Vector3d::Constant(square(floor.shift_sd)),
        Eigen::Vector3d::Constant(square(floor.angle_sd));

    model.background.topLeftCorner(n, n) =
        square(floor.background_sd) *
        (-patch_distances(observations.field).array() / floor.background_length).exp();
    model.background.topLeftCorner(n, n).array() += square(floor.offset_sd);
    const Eigen::VectorXd hubs = hub_slopes(patches);
    model.background.topLeftCorner(n, n) += square(floor.hub_sd) * hubs * hubs.transpose();
    for (const Patch& patch : patches)
        model.middle += patch.centre / static_cast<double>(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Patch& patch = patches[static_cast<std::size_t>(i)];
        model.white[i] = floor.white_scale * variance_of_gap(patch);
        model.motion.row(i).head<3>() = patch.normal;
        model.motion.row(i).tail<3>() = (patch.centre - model.middle).cross(patch.normal);
    }

    const Eigen::Matrix3d ends = end_background(floor);
    std::vector<Eigen::Index> given;
    for (Eigen::Index i = 0; i < 3; ++i) {
        if (observations.scalars.values[static_cast<std::size_t>(i)]) given.push_back(i);
    }
    for (std::size_t i = 0; i < given.size(); ++i) {
        const Eigen::Index row = n + static_cast<Eigen::Index>(i);
        model.white[row] =
            square(observations.scalars.values[static_cast<std::size_t>(given[i])]->sd);
        for (std::size_t j = 0; j < given.size(); ++j)
            model.background(row, n + static_cast<Eigen::Index>(j)) = ends(given[i], given[j]);
    }
    add_channel_errors(model, observations, floor);
    return model;
}

Eigen::MatrixXd ErrorModel::without_registration() const
{
    Eigen::MatrixXd sum = background;
    sum.diagonal() += white;
    return sum;
}

Eigen::MatrixXd ErrorModel::covariance() const
{
    return without_registration() + motion * motion_variance.asDiagonal() * motion.transpose();
}

}  // namespace braidzone

#pragma once

#include "discrepancy/channel_errors.hpp"
#include "discrepancy/diagnosis_problem.hpp"
#include "discrepancy/discrepancy_field.hpp"
#include "discrepancy/error_model.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace braidzone::test {

constexpr double patch_point_sd = 0.08e-3;  // [m]
constexpr int patch_points = 12;

/// Patches all over a cylinder along z, `rows` of 0.8 mm, without measured points.
inline DiscrepancyField cylinder_field(int rows, double radius)
{
    DiscrepancyField field;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < field.options.around; ++column) {
            Patch patch;
            patch.row = row;
            patch.column = column;
            patch.points.assign(patch_points, 0);
            patch.weights.assign(patch_points, 1.0 / patch_points);
            patch.point_sd = patch_point_sd;
            patch.arc_length = (row + 0.5) * field.options.length;
            patch.angle = 2.0 * std::numbers::pi * (column + 0.5) / field.options.around;
            patch.normal = Vec3(std::cos(patch.angle), std::sin(patch.angle), 0.0);
            patch.centre = radius * patch.normal + Vec3(0.0, 0.0, patch.arc_length);
            patch.area =
                field.options.length * 2.0 * std::numbers::pi * radius / field.options.around;
            patch.contact_share = 1.0;
            field.patches.push_back(patch);
        }
    }
    return field;
}

/// The errors and the unknown effect of a surface, without candidates.
inline DiagnosisProblem errors_of(const Observations& observations, const NoiseFloor& floor = {})
{
    DiagnosisProblem problem;
    problem.covariance = make_error_model(observations, floor).covariance();
    problem.distances = patch_distances(observations.field);
    problem.correlation_length = floor.background_length;
    problem.unknown_amplitudes = {0.04e-3, 0.08e-3, 0.16e-3, 0.32e-3};
    problem.unknown_lengths = {1e-3, 2e-3, 4e-3};
    problem.unknown_channels = unknown_channels(observations);
    problem.unknown_deviations = {1.0, 4.0};
    return problem;
}

/// Normal vectors of a covariance, one a column.
inline Eigen::MatrixXd draws(const Eigen::MatrixXd& covariance, int count, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd lower = covariance.llt().matrixL();
    return lower *
           Eigen::MatrixXd::NullaryExpr(covariance.rows(), count, [&] { return normal(random); });
}

}  // namespace braidzone::test

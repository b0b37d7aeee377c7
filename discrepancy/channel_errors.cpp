#include "discrepancy/channel_errors.hpp"

namespace braidzone {
namespace {

// What an unknown reason moves: a unit of `DiagnosisProblem::unknown_deviations`.
constexpr double unknown_length = 1e-3;        // [m]
constexpr double unknown_density = 0.1;        // relative
constexpr double unknown_density_over = 2e-3;  // [m]
constexpr double unknown_force = 0.2;          // relative

double square(double x)
{
    return x * x;
}

/// Distances between the places' feet [m].
Eigen::MatrixXd place_distances(const DensityField& field)
{
    const auto n = static_cast<Eigen::Index>(field.feet.size());
    return Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index i, Eigen::Index j) {
        return (field.feet[static_cast<std::size_t>(i)] - field.feet[static_cast<std::size_t>(j)])
            .norm();
    });
}

}  // namespace

void add_channel_errors(ErrorModel& error, const Observations& observations,
                        const NoiseFloor& floor)
{
    const ResidualRows rows = residual_rows(observations);
    const DensityField& density = observations.density;
    for (Eigen::Index i = 0; i < rows.num_density; ++i)
        error.white[rows.density + i] = square(density.places[static_cast<std::size_t>(i)].sd);
    if (rows.num_density > 0) {
        const Eigen::ArrayXXd relative =
            square(floor.density_sd) *
                (-place_distances(density).array() / floor.background_length).exp() +
            square(floor.density_scale_sd);
        error.background.block(rows.density, rows.density, rows.num_density, rows.num_density) =
            (density.scale * density.scale.transpose()).array() * relative;
    }
    if (const auto& force = observations.scalars.contact_force) {
        error.white[rows.force] = square(force->force.sd);
        error.background(rows.force, rows.force) = square(floor.force_sd * force->force.value);
    }
}

std::vector<Eigen::MatrixXd> unknown_channels(const Observations& observations)
{
    const ResidualRows rows = residual_rows(observations);
    const Eigen::Index first = rows.num_patches, count = rows.size - first;
    std::vector<Eigen::MatrixXd> channels;
    const auto add = [&](Eigen::Index row, const Eigen::MatrixXd& block) {
        if (block.size() == 0) return;
        channels.emplace_back(Eigen::MatrixXd::Zero(count, count));
        channels.back().block(row - first, row - first, block.rows(), block.cols()) = block;
    };
    add(rows.lengths,
        square(unknown_length) * Eigen::MatrixXd::Identity(rows.num_lengths, rows.num_lengths));
    const DensityField& density = observations.density;
    const Eigen::VectorXd size = unknown_density * density.scale;
    add(rows.density,
        (size * size.transpose()).array() *
            (-0.5 * (place_distances(density).array() / unknown_density_over).square()).exp());
    if (const auto& force = observations.scalars.contact_force) {
        add(rows.force,
            Eigen::MatrixXd::Constant(1, 1, square(unknown_force * force->force.value)));
    }
    return channels;
}

Eigen::MatrixXd shape_correlation(const Observations& observations, double length)
{
    const ResidualRows rows = residual_rows(observations);
    const Eigen::Index first = rows.num_patches, count = rows.size - first;
    Eigen::MatrixXd correlation = Eigen::MatrixXd::Zero(count, count);
    correlation.block(rows.density - first, rows.density - first, rows.num_density,
                      rows.num_density) =
        (-place_distances(observations.density).array() / length).exp();
    if (rows.num_force > 0) correlation(rows.force - first, rows.force - first) = 1.0;
    return correlation;
}

}  // namespace braidzone

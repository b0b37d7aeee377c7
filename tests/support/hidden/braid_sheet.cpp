#include "support/hidden/braid_sheet.hpp"

#include "support/hidden/sheet_terms.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace braidzone::hidden {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double largest_step = 0.1e-3;  // of a radius in one iteration [m]
constexpr double small_step = 0.05e-6;   // at which the sheet is at rest [m]
constexpr int most_iterations = 100;

/// Newton's step; compressed wires soften the sheet sideways, which is left out where it would
/// make the second derivatives indefinite.
class NewtonStep {
public:
    Eigen::VectorXd operator()(const SheetTerms& sheet, const Eigen::VectorXd& radii)
    {
        for (const double sideways : {1.0, 0.5, 0.0}) {
            const Assembly all = sheet.assemble(radii, true, sideways);
            Sparse matrix(radii.size(), radii.size());
            matrix.setFromTriplets(all.hessian.begin(), all.hessian.end());
            if (!is_analysed_) solver_.analyzePattern(matrix);
            is_analysed_ = true;
            solver_.factorize(matrix);
            if (solver_.info() == Eigen::Success) return -solver_.solve(all.gradient);
        }
        throw std::runtime_error("the hidden device's second derivatives are not definite");
    }

private:
    Eigen::SimplicialLLT<Sparse, Eigen::Lower> solver_;
    bool is_analysed_ = false;
};

}  // namespace

BraidSheet sheet_of(const FlowDiverter& device)
{
    constexpr double bending_share = 0.3;
    const double t = device.braid_ratio;
    const double secant = 1.0 + t * t;
    const double width = std::numbers::pi * device.nominal_radius() / (0.5 * device.num_wires);
    BraidSheet sheet;
    sheet.radius = device.nominal_radius();
    sheet.length = device.nominal_length;
    sheet.braid_ratio = t;
    sheet.wire_stiffness = device.surface_coefficient * secant / (2.0 * t);
    sheet.bending_stiffness =
        bending_share * device.surface_coefficient * width * width * secant * secant / (2.0 * t);
    sheet.radial_stiffness = device.radial_coefficient / device.reference_node_area;
    sheet.force_scale = device.force_scale;
    return sheet;
}

Vec3 SheetPlace::ray(int row, int column) const
{
    const CrossSection& section = sections[static_cast<std::size_t>(row)];
    const double angle = angles[at(row, column)];
    return std::cos(angle) * section.normal + std::sin(angle) * section.binormal;
}

SheetEnergy sheet_energy(const BraidSheet& sheet, const SheetPlace& place,
                         const std::vector<double>& radii)
{
    const auto size = static_cast<Eigen::Index>(radii.size());
    const Assembly all =
        SheetTerms(sheet, place)
            .assemble(Eigen::Map<const Eigen::VectorXd>(radii.data(), size), false, 1.0);
    return {all.energy, {all.gradient.data(), all.gradient.data() + size}};
}

SheetAtRest at_rest(const BraidSheet& sheet, const SheetPlace& place, std::vector<double> start)
{
    const SheetTerms problem(sheet, place);
    const auto size = static_cast<Eigen::Index>(start.size());
    Eigen::VectorXd radii = Eigen::Map<const Eigen::VectorXd>(start.data(), size);
    SheetAtRest rest;
    NewtonStep newton;
    double energy = problem.assemble(radii, false, 1.0).energy;
    rest.last_step = largest_step;
    while (rest.last_step > small_step) {
        if (++rest.iterations > most_iterations)
            throw std::runtime_error("the hidden device does not come to rest");
        Eigen::VectorXd step = newton(problem, radii);
        step *= std::min(1.0, largest_step / step.cwiseAbs().maxCoeff());
        rest.last_step = step.cwiseAbs().maxCoeff();
        for (int halvings = 0; halvings < 12; ++halvings) {
            const double next = problem.assemble(radii + step, false, 1.0).energy;
            if (next <= energy || rest.last_step <= small_step) {
                energy = next;
                break;
            }
            step *= 0.5;
        }
        radii += step;
    }
    rest.radii.assign(radii.data(), radii.data() + size);
    rest.pressure = problem.wall_pressure(radii);
    return rest;
}

}  // namespace braidzone::hidden

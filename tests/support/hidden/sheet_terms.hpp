#pragma once

#include "support/hidden/braid_sheet.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace braidzone::hidden {

/// Sum of an energy, its gradient, and the lower half of its second derivatives.
struct Assembly {
    double energy = 0.0;
    Eigen::VectorXd gradient;
    std::vector<Eigen::Triplet<double>> hessian;
    bool with_hessian = false;
    double sideways = 1.0;  ///< share of the second derivatives that compressed wires take away

    void add(std::size_t i, std::size_t j, double value)
    {
        if (i >= j) hessian.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
    }
};

/// A term that is the square of something linear: it adds w (sum of c_a r_a)^2 / 2.
struct LinearTerm {
    std::array<std::size_t, 9> nodes;
    std::array<double, 9> coefficients;
    double weight;
};

/// The terms of a sheet's energy (`braid_sheet.hpp`), of the wall's and of the loads', by the
/// radii.
class SheetTerms {
public:
    SheetTerms(const BraidSheet& sheet, const SheetPlace& place);

    /// All terms at some radii.
    /// @param sideways  see `Assembly`
    Assembly assemble(const Eigen::VectorXd& radii, bool with_hessian, double sideways) const;

    /// On the wall, of each point [Pa].
    std::vector<double> wall_pressure(const Eigen::VectorXd& radii) const;

private:
    struct Angle {
        double sine, cosine;
    };

    int row(std::size_t i) const { return static_cast<int>(i) / place_.columns; }
    Vec3 origin(std::size_t i) const;
    double area(std::size_t i) const;
    Angle braid_angle(int row) const;
    LinearTerm bend(int row, int column, double family) const;
    static void add_bend(const LinearTerm& term, const Eigen::VectorXd& radii, Assembly& sum);
    void add_wires(const std::vector<Vec3>& points, Assembly& sum) const;
    void add_corner(const std::vector<Vec3>& points, const std::array<std::size_t, 3>& nodes,
                    int row, double along_sign, double around_sign, Assembly& sum) const;
    void add_wire(const Vec3& wire, const std::array<std::size_t, 3>& nodes,
                  const std::array<double, 3>& coefficients, double weight, Assembly& sum) const;
    void add_node(std::size_t i, double radius, const Vec3& point, Assembly& sum) const;

    const BraidSheet& sheet_;
    const SheetPlace& place_;
    double row_step_ = 0.0, around_step_ = 0.0, chord_ = 1.0;
    std::vector<Vec3> rays_;
    std::vector<LinearTerm> bends_;
};

}  // namespace braidzone::hidden

#pragma once

#include "porous/resistance_sheet.hpp"

#include <vector>

namespace braidzone {

/// A piece of a rhombus: a quadrature point of the sheet.
struct SheetPiece {
    Vec3 position = Vec3::Zero();  ///< [m]
    int rhombus = -1;
    double area = 0.0;  ///< [m^2]; the pieces of a rhombus sum to its area
};

/// Cuts a rhombus into m x m pieces of equal area, with m the smallest number that makes their
/// edges no longer than `longest_edge`.
/// @param longest_edge  [m]; > 0
std::vector<SheetPiece> cut_into_pieces(const BraidSurface& surface, std::size_t rhombus,
                                        double longest_edge);

/// One-dimensional cosine kernel phi(r) = (1 + cos(pi r / m)) / (2 m) for |r| < m, else 0
/// (Peskin 2002, doi 10.1017/S0962492902000077, with general half-width). For integer m >= 1 it
/// sums to 1 over r = x + integers for every shift x; its integral is 1.
/// @param distance    r, in units of the spacing [-]
/// @param half_width  m, in units of the spacing [-]; > 0
double cosine_kernel(double distance, double half_width);

/// The cosine kernel at the integers around a point, 2 m of them from `first` on. The cosine of
/// each follows from the first one's by the sum of angles: one evaluation instead of 2 m.
class CosineWeights {
public:
    /// @param half_width  m, in units of the spacing; >= 1
    explicit CosineWeights(int half_width);

    /// @param position  of the point, in units of the spacing
    void evaluate(double position);

    int first() const { return first_; }
    double operator[](int i) const { return values_[static_cast<std::size_t>(i)]; }

private:
    int half_width_;
    int first_ = 0;
    std::vector<Vec2> turns_;
    std::vector<double> values_;
};

}  // namespace braidzone

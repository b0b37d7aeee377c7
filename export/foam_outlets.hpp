#pragma once

#include "core/vessel.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace braidzone {

/// A pressure at each outlet.
struct OutletPressures {
    std::vector<double> pressures;  ///< outlet_1, outlet_2, ... [Pa]; empty: zero at each
};

/// By how much the shares may miss a sum of 1.
constexpr double share_tolerance = 1e-6;

/// Shares of the inflow that leave at each outlet.
struct OutletShares {
    std::vector<double> shares;  ///< outlet_1, outlet_2, ...; positive, their sum is 1
};

/// Shares of the inflow as the cubes of the outlets' radii (Murray 1926,
/// doi 10.1073/pnas.12.3.207): the same shear on the wall of each branch.
struct MurraySplit {};

using FoamOutlets = std::variant<OutletPressures, OutletShares, MurraySplit>;

/// An opening of the vessel as a patch, and what holds there.
struct FoamOpening {
    std::string name;            ///< "inlet", or "outlet_1", ...
    double area = 0.0;           ///< [m^2]
    Vec3 centre = Vec3::Zero();  ///< [m]
    double pressure = 0.0;       ///< at an outlet without a share [Pa]
    /// Prescribed part of the inflow that leaves here. One outlet of a split, the one with the
    /// largest share, has none: its pressure is zero, and what leaves there closes the balance.
    std::optional<double> share = {};
    bool is_inlet() const { return name == "inlet"; }
};

/// The openings of a vessel in its order, with their conditions.
/// @param inlet  index of the opening that is the inlet
/// @throws InputError if `inlet` is no opening, or if there are not as many pressures or shares as
///         outlets, or a share is not positive, or they do not sum to 1
std::vector<FoamOpening> foam_openings(const Vessel& vessel, int inlet, const FoamOutlets& outlets);

}  // namespace braidzone

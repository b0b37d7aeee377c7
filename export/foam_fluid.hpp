#pragma once

#include "core/carreau_yasuda.hpp"
#include "core/fluid.hpp"

#include <optional>
#include <string>

namespace braidzone {

/// Text of constant/transportProperties: a Newtonian fluid, or OpenFOAM's BirdCarreau, which with
/// its exponent `a` is the model of Carreau and Yasuda.
std::string transport_properties(const Fluid& fluid,
                                 const std::optional<CarreauYasuda>& rheology = std::nullopt);

/// Text of constant/turbulenceProperties: laminar.
std::string turbulence_properties();

/// Which viscosity a device in shear-thinning blood resists with, for the user to read.
/// @param fluid  with the viscosity that the device's resistance was found with
std::string rheology_note(const Fluid& fluid);

}  // namespace braidzone

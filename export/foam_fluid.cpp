#include "export/foam_fluid.hpp"

#include "export/foam_format.hpp"

#include <fmt/format.h>

namespace braidzone {

std::string transport_properties(const Fluid& fluid, const std::optional<CarreauYasuda>& rheology)
{
    const std::string header = foam_header("dictionary", "constant", "transportProperties");
    if (!rheology)
        return header + fmt::format(
                            "// Kinematic viscosity [m^2/s]: {} Pa s over {} kg/m^3.\n"
                            "transportModel  Newtonian;\nnu              [0 2 -1 0 0 0 0] {};\n",
                            fluid.viscosity, fluid.density, fluid.viscosity / fluid.density);
    return header +
           fmt::format(
               R"(// Carreau-Yasuda blood; kinematic viscosities [m^2/s]: {mu0} and {muInf} Pa s over {rho} kg/m^3.
transportModel  BirdCarreau;
BirdCarreauCoeffs
{{
    nu0             [0 2 -1 0 0 0 0] {nu0};
    nuInf           [0 2 -1 0 0 0 0] {nuInf};
    k               [0 0 1 0 0 0 0] {k};
    n               [0 0 0 0 0 0 0] {n};
    a               [0 0 0 0 0 0 0] {a};
}}
)",
               fmt::arg("mu0", rheology->zero_shear_viscosity),
               fmt::arg("muInf", rheology->infinite_shear_viscosity),
               fmt::arg("rho", fluid.density),
               fmt::arg("nu0", rheology->zero_shear_viscosity / fluid.density),
               fmt::arg("nuInf", rheology->infinite_shear_viscosity / fluid.density),
               fmt::arg("k", rheology->relaxation_time), fmt::arg("n", rheology->power_index),
               fmt::arg("a", rheology->yasuda_exponent));
}

std::string turbulence_properties()
{
    return foam_header("dictionary", "constant", "turbulenceProperties") +
           "simulationType  laminar;\n";
}

std::string rheology_note(const Fluid& fluid)
{
    return fmt::format(
        "carreau-yasuda: between the wires the shear is high, and the resolved flow does not know "
        "it: "
        "the device's resistance keeps the Newtonian fluid.viscosity = {:.6g} Pa s",
        fluid.viscosity);
}

}  // namespace braidzone

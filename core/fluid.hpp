#pragma once

namespace braidzone {

/// A Newtonian fluid. The defaults are blood at 37 degrees C and arterial shear rates, as used in
/// most aneurysm studies (Steinman and Pereira 2019, doi 10.3171/2019.4.FOCUS19181).
struct Fluid {
    double density = 1056.0;    ///< [kg/m^3]
    double viscosity = 3.5e-3;  ///< dynamic [Pa s]
};

}  // namespace braidzone

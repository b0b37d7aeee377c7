#include "export/lattice_readme.hpp"

namespace braidzone {

namespace {

constexpr const char* numpy_readme = R"(# NumPy arrays
`cell_type.npy` (0 unused, 1 wall, 2 fluid, 10 inlet, 11, 12, ... outlets), `darcy.npy` [1/m^2] and
`forchheimer.npy` [1/m], along the normal of the braid, indexed [i, j, k] along x, y, z; `normal.npy` is
indexed [c, i, j, k]. Node [i, j, k] lies at `origin` + `spacing` (i, j, k) of `../lattice.json`.

    import numpy
    cell_type, darcy = numpy.load("cell_type.npy"), numpy.load("darcy.npy")

The momentum sink is S = -(mu D + 1/2 rho F |U|) U per volume, along the normal; tangentially the ratios
of `../lattice.json` times that.
)";

constexpr const char* openlb_readme = R"(# OpenLB
`olb_porosity.vdb`: for a driver that gives the functor

    AnalyticalPorosityVolumeF<T> porosity("olb_porosity.vdb", spacing);

(FEATURES with VDB) as the field POROSITY to `PorousBGKdynamics`. It holds for the time step, velocity and viscosity of `../lattice.json` only. Nodes must lie at
(i + 1/2) dx from the origin of the reader. Linear part only; the same along and across the sheet.

`case.vti`: for a driver with `BlockVTIreader3D`: `flags` (0 unused, 1 wall, 2 fluid, 10 inlet, 11, 12,
... outlets), `darcy_d` [1/m^2], `forchheimer_f` [1/m], one value a node, spacing in metres, origin 0.
Where the node (0, 0, 0) lies in the vessel's file: `origin` of `../lattice.json`. Of the stock porous
collisions none has a quadratic part (in 1.9 that of Guo and Zhao is switched off in the code).
)";

constexpr const char* palabos_readme = R"(# Palabos
`geometry.dat`: integers in text, x slowest and z fastest: 0 fluid and openings, 1 wall (bounce-back), 2
nothing. As `examples/tutorial/permeability` reads it:

    ./permeability geometry.dat out NX NY NZ dp

with NX NY NZ the `dims` of `box` under `palabos` in `../lattice.json`; node (0, 0, 0) is its `first`. The
tutorial drives flow along x, through the first and the last layer: the openings must lie there (`openings`
of the export lays them on faces of the box). The walls only: the device's resistance is not in it.
)";

constexpr const char* walberla_readme = R"(# waLBerla
`mask_u8.raw`: a byte for each node, x fastest, 1 where there is fluid or an opening, else 0. For
`geometry::BinaryRawFile` with the `dims` of `../lattice.json`:

    BinaryRawFile { filename mask_u8.raw; size < NX, NY, NZ >; datatype uint8; }

The walls only: the device's resistance is not in it.
)";

constexpr const char* hemoflow_readme = R"(# HemoFlow
`case.npz`, `setup.xml` and `flow.txt`, for github.com/gzavo/hemoflow:

    hemoFlow setup.xml

run in this folder. Flags: 0 unused, 1 wall, 2 fluid, 10 inlet (velocity), 11 outlet (pressure), 12, ...
outlets (velocity, by the cube of the radius). `stent` times `linCoeff` is mu D dx of each node. The
Reynolds number in setup.xml is that of half the peak velocity of `../lattice.json`; `flow.txt` scales it
in time (steady here). Node (0, 0, 0) is the first one between the openings (`box` in `../lattice.json`).

One weight scales the linear and the quadratic part, which acts on each component of the velocity by
itself; the same along and across the sheet. HemoFlow has blood of its own (1055 kg/m^3, 3.22e-6 m^2/s,
Carreau below).
)";

constexpr const char* lbpm_readme = R"(# LBPM
`input.db` with `labels_u8.raw` (0 solid, 1 fluid, 2 device), `porosity_f64.raw` and
`permeability_vox2_f64.raw`, x fastest, for the greyscale simulator of github.com/OPM/LBPM:

    mpirun -np 1 lbpm_greyscale_simulator input.db

run in this folder. For more processes change `nproc` and `n`, where n times nproc must be N.

Flow runs along z between two densities, `din` at the lower and `dout` at the upper face; those here
are an estimate for half the peak velocity of `../lattice.json`: compare the velocities that it prints
(vax, vay, vaz of Permeability.csv, in node spacings a time step) and scale the difference. Node (0, 0,
0) is the first one between the openings (`box` in `../lattice.json`).

Effective resistance is nu eps / K, with a porosity eps of 0.999999 in the device, where LBPM would
leave it out at 1. The quadratic part is LBPM's own, Ergun's, which no input changes: `../lattice.json`
says how many times the sheet's it is. The same along and across the sheet. LBPM's manual recommends a
`tau` of 0.7 to 1.5; its MRT collision ran with 0.508, not with 0.502.
)";

}  // namespace

std::string lattice_readme(LatticeTarget target)
{
    switch (target) {
        case LatticeTarget::numpy:
            return numpy_readme;
        case LatticeTarget::openlb:
            return openlb_readme;
        case LatticeTarget::palabos:
            return palabos_readme;
        case LatticeTarget::walberla:
            return walberla_readme;
        case LatticeTarget::hemoflow:
            return hemoflow_readme;
        case LatticeTarget::lbpm:
            return lbpm_readme;
    }
    return {};
}

}  // namespace braidzone

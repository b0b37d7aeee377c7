#include "export/lattice_export.hpp"

#include "core/error.hpp"
#include "export/lattice_arrays.hpp"
#include "export/lattice_hemoflow.hpp"
#include "export/lattice_openlb.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace braidzone {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

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

with NX NY NZ the `dims` of `../lattice.json`. The walls only: the device's resistance is not in it.
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
in time (steady here).

One weight scales the linear and the quadratic part, which acts on each component of the velocity by
itself; the same along and across the sheet. HemoFlow has blood of its own (1055 kg/m^3, 3.22e-6 m^2/s,
Carreau below).
)";

struct Target {
    LatticeTarget target;
    const char* name;
    const char* readme;
    bool has_linear;              ///< takes the linear resistance
    const char* quadratic_limit;  ///< what it takes of the quadratic one; null: all
    bool has_normal;              ///< takes a tensor
};

constexpr Target targets[] = {
    {LatticeTarget::numpy, "numpy", numpy_readme, true, nullptr, true},
    {LatticeTarget::openlb, "openlb", openlb_readme, true, "the linear part of the resistance only",
     false},
    {LatticeTarget::palabos, "palabos", palabos_readme, false, nullptr, false},
    {LatticeTarget::walberla, "walberla", walberla_readme, false, nullptr, false},
    {LatticeTarget::hemoflow, "hemoflow", hemoflow_readme, true,
     "the quadratic part in one ratio to the linear one, on each component of the velocity by "
     "itself",
     false},
};

const Target& entry_of(LatticeTarget target)
{
    return *std::find_if(std::begin(targets), std::end(targets),
                         [&](const Target& entry) { return entry.target == target; });
}

Json vector_as_json(const Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

Json openings_as_json(const LatticeNodes& nodes, const Vessel& vessel)
{
    Json openings = Json::array();
    for (const LatticeOpening& entry : nodes.openings) {
        const Opening& opening = vessel.openings[static_cast<std::size_t>(entry.opening)];
        openings.push_back(
            {{"cell_type", entry.code},
             {"kind",
              entry.code == static_cast<std::uint8_t>(NodeType::inlet) ? "inlet" : "outlet"},
             {"centre_m", vector_as_json(opening.centre)},
             {"normal_outwards", vector_as_json(opening.normal)},
             {"area_m2", opening.area},
             {"radius_m", opening.radius},
             {"num_nodes", entry.num_nodes}});
    }
    return openings;
}

Json units_as_json(const LatticeUnits& units, const LatticeExportOptions& options)
{
    return {{"peak_velocity_m_s", options.flow.peak_velocity},
            {"velocity_lu", options.flow.velocity_lu},
            {"time_step_s", units.time_step},
            {"viscosity_lu", units.viscosity_lu},
            {"relaxation_time_lu", units.relaxation_time_lu},
            {"mach", units.mach},
            {"largest_drag_lu", units.largest_drag_lu},
            {"largest_inertia_lu", units.largest_inertia_lu},
            {"drag", "per time step (a + b |u|) u, a = nu D dt, b = F dx / 2"}};
}

Json counts_as_json(const LatticeNodes& nodes)
{
    std::int64_t fluid = 0, wall = 0;
    for (const std::uint8_t type : nodes.type) {
        fluid += type == static_cast<std::uint8_t>(NodeType::fluid);
        wall += type == static_cast<std::uint8_t>(NodeType::wall);
    }
    return {{"all", nodes.type.size()},
            {"fluid", fluid},
            {"wall", wall},
            {"resisting", nodes.resisting.size()}};
}

/// What the targets leave out.
std::vector<std::string> lattice_notes(const LatticeNodes& nodes,
                                       const LatticeExportOptions& options)
{
    std::vector<std::string> notes;
    const bool is_quadratic = std::any_of(nodes.forchheimer.begin(), nodes.forchheimer.end(),
                                          [](double value) { return value > 0.0; });
    for (const LatticeTarget target : options.targets) {
        const Target& entry = entry_of(target);
        if (!entry.has_linear) {
            notes.push_back(fmt::format("lattice: {} takes the walls, not the device's resistance",
                                        entry.name));
            continue;
        }
        if (entry.quadratic_limit != nullptr && is_quadratic)
            notes.push_back(fmt::format("lattice: {} takes {}", entry.name, entry.quadratic_limit));
        if (!entry.has_normal && nodes.tangential_ratio.linear != 1.0)
            notes.push_back(
                fmt::format("lattice: {} has one resistance for all directions: the normal one, "
                            "instead of {:.4g} times that along the sheet",
                            entry.name, nodes.tangential_ratio.linear));
    }
    return notes;
}

Json as_json(const LatticeNodes& nodes, const Vessel& vessel, const Fluid& fluid,
             const LatticeExportOptions& options, const LatticeUnits& units,
             const std::vector<std::string>& notes)
{
    Json json;
    json["format"] = 1;
    json["dims"] = nodes.grid.dims;
    json["spacing_m"] = nodes.grid.spacing;
    json["origin_m"] = vector_as_json(nodes.grid.origin);
    json["axis_order"] =
        "node (i, j, k) at origin + spacing (i, j, k); x fastest unless a target's "
        "README says otherwise";
    json["cell_types"] = {{"unused", 0}, {"wall", 1}, {"fluid", 2}, {"inlet", 10}, {"outlet", 11}};
    json["openings"] = openings_as_json(nodes, vessel);
    json["num_nodes"] = counts_as_json(nodes);
    json["fluid"] = {{"density_kg_m3", fluid.density}, {"viscosity_Pa_s", fluid.viscosity}};
    json["resistance"] = {
        {"convention", "S = -(mu D + 1/2 rho F |U|) U per volume, along the normal"},
        {"tangential_ratio", nodes.tangential_ratio.linear},
        {"tangential_ratio_quadratic", nodes.tangential_ratio.quadratic},
        {"integral_of_darcy_m", resistance_integral(nodes)}};
    json["units"] = units_as_json(units, options);
    json["notes"] = notes;
    return json;
}

}  // namespace

std::string target_name(LatticeTarget target)
{
    return entry_of(target).name;
}

std::vector<LatticeTarget> default_lattice_targets()
{
    std::vector<LatticeTarget> targets_of_any_vessel = all_lattice_targets();
    std::erase(targets_of_any_vessel, LatticeTarget::hemoflow);
    return targets_of_any_vessel;
}

std::vector<LatticeTarget> all_lattice_targets()
{
    std::vector<LatticeTarget> all;
    for (const Target& entry : targets)
        all.push_back(entry.target);
    return all;
}

std::vector<std::string> write_lattice(const fs::path& folder, const LatticeNodes& nodes,
                                       const Vessel& vessel, const Fluid& fluid,
                                       const LatticeExportOptions& options)
{
    const LatticeUnits units = propose_units(nodes, fluid, options.flow);
    for (const LatticeTarget target : options.targets) {
        const fs::path place = folder / target_name(target);
        fs::create_directories(place);
        write_text_file(place / "README.md", entry_of(target).readme);
        switch (target) {
            case LatticeTarget::numpy:
                write_lattice_arrays(place, nodes);
                break;
            case LatticeTarget::openlb:
                write_openlb(place, nodes, fluid, units);
                break;
            case LatticeTarget::palabos:
                write_palabos_geometry(place / "geometry.dat", nodes);
                break;
            case LatticeTarget::hemoflow:
                write_hemoflow(place, nodes, vessel, fluid, options.flow);
                break;
            case LatticeTarget::walberla:
                write_walberla_mask(place / "mask_u8.raw", nodes);
                break;
        }
    }
    std::vector<std::string> notes = lattice_notes(nodes, options);
    for (const std::string& warning : unit_warnings(units, options.flow))
        notes.push_back(warning);
    fs::create_directories(folder);
    write_text_file(folder / "lattice.json",
                    as_json(nodes, vessel, fluid, options, units, notes).dump(2) + "\n");
    return notes;
}

}  // namespace braidzone

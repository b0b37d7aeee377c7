#include "export/lattice_lbpm.hpp"

#include "core/error.hpp"
#include "export/binary_file.hpp"
#include "export/node_box.hpp"
#include "export/resisting_planes.hpp"
#include "export/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace braidzone {

namespace {

constexpr double device_porosity = 0.999999;

enum class Label : std::uint8_t { solid = 0, fluid = 1, device = 2 };

void require_inlet_against_outlets(const LatticeNodes& nodes, const Vessel& vessel,
                                   const OpeningBox& between)
{
    for (std::size_t i = 0; i < between.faces.size(); ++i) {
        const bool is_inlet = i == 0;
        const bool on_inlet_face = between.faces[i] == between.faces.front();
        if (between.faces[i].axis == 2 && is_inlet == on_inlet_face) continue;
        const Vec3& centre =
            vessel.openings[static_cast<std::size_t>(nodes.openings[i].opening)].centre;
        throw ConfigError(fmt::format(
            "export.targets: lbpm drives flow along z, from the inlet on one face of the box to "
            "all outlets on the opposite one, but the {} at ({:.4g}, {:.4g}, {:.4g}) mm lies on "
            "the {} face across {}; state openings = \"extended_z\" beside targets, or leave this "
            "target out",
            is_inlet ? "inlet" : "outlet", 1e3 * centre[0], 1e3 * centre[1], 1e3 * centre[2],
            between.faces[i].is_upper ? "upper" : "lower", "xyz"[between.faces[i].axis]));
    }
}

/// Writes one value a node of the box, plane by plane across z.
/// @param base    value of a node by its type
/// @param device  value of a resisting node by its place among them
template <typename Value, typename Base, typename Device>
void write_nodes(const std::filesystem::path& path, const LatticeNodes& nodes, const NodeBox& box,
                 Base base, Device device)
{
    const auto& [nx, ny, nz] = box.dims();
    const auto place_in_plane = [&](int i, int j) {
        return static_cast<std::size_t>((j - box.first[1]) * nx + i - box.first[0]);
    };
    BinaryFile file(path);
    const ResistingPlanes planes(nodes, 2);
    std::vector<Value> plane(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
    for (int k = box.first[2]; k <= box.last[2]; ++k) {
        for (int j = box.first[1]; j <= box.last[1]; ++j)
            for (int i = box.first[0]; i <= box.last[0]; ++i)
                plane[place_in_plane(i, j)] = base(nodes.type[nodes.grid.index(i, j, k)]);
        for (const std::size_t node : planes.in_plane(k)) {
            const std::array<int, 3> place = place_of(nodes.grid, nodes.resisting[node]);
            plane[place_in_plane(place[0], place[1])] = device(node);
        }
        file.write(plane);
    }
    file.close();
}

/// How much denser the fluid is at the inlet, of 1: three times the pressure drop of Poiseuille
/// flow.
double driving_density(const LatticeNodes& nodes, const Vessel& vessel, const NodeBox& box,
                       const LatticeUnits& units, const LatticeFlowOptions& flow)
{
    const Opening& inlet =
        vessel.openings[static_cast<std::size_t>(nodes.openings.front().opening)];
    const double radius_lu = inlet.radius / nodes.grid.spacing;
    return 3.0 * 8.0 * units.viscosity_lu * 0.5 * flow.velocity_lu * (box.dims()[2] - 1) /
           (radius_lu * radius_lu);
}

std::string input_text(const NodeBox& box, bool inlet_is_upper, const LatticeUnits& units,
                       double density)
{
    const auto& [nx, ny, nz] = box.dims();
    const std::string size = fmt::format("{}, {}, {}", nx, ny, nz);
    const double upstream = 1.0 + 0.5 * density, downstream = 1.0 - 0.5 * density;
    constexpr double micrometres = 1e6;
    return fmt::format(
        R"(// Time step {:.9g} s, node spacing {:.9g} m: velocities times {:.6g} are in m/s.
Domain {{
   Filename = "labels_u8.raw"
   ReadType = "8bit"
   nproc = 1, 1, 1
   n = {}
   N = {}
   voxel_length = {:.9g}
   ReadValues = 0, 1, 2
   WriteValues = 0, 1, 2
   BC = 3
}}
Greyscale {{
   FileVoxelPorosityMap = "porosity_f64.raw", "double"
   FileVoxelPermeabilityMap = "permeability_vox2_f64.raw", "double"
   // The default, IMRT, diverges between two densities.
   collision = "MRT"
   tau = {:.9g}
   F = 0.0, 0.0, 0.0
   din = {:.9g}
   dout = {:.9g}
   timestepMax = 100000
   tolerance = 0.0001
}}
Analysis {{
   analysis_interval = 1000
}}
Visualization {{
}}
)",
        units.time_step, units.spacing, units.spacing / units.time_step, size, size,
        micrometres * units.spacing, units.relaxation_time_lu,
        inlet_is_upper ? downstream : upstream, inlet_is_upper ? upstream : downstream);
}

}  // namespace

double lbpm_quadratic_ratio(const LatticeNodes& nodes)
{
    double own = 0.0;
    for (const double darcy : nodes.darcy)
        own += lbpm_ergun_constant * std::sqrt(darcy);
    const double sheet =
        0.5 * std::accumulate(nodes.forchheimer.begin(), nodes.forchheimer.end(), 0.0);
    if (!(own > 0.0)) return 0.0;
    return sheet > 0.0 ? own / sheet : std::numeric_limits<double>::infinity();
}

std::vector<LatticeFile> write_lbpm(const std::filesystem::path& folder, const LatticeNodes& nodes,
                                    const Vessel& vessel, const LatticeUnits& units,
                                    const LatticeFlowOptions& flow)
{
    const OpeningBox between = box_between_openings(nodes, vessel, LatticeTarget::lbpm);
    require_inlet_against_outlets(nodes, vessel, between);
    const NodeBox& box = between.box;
    write_nodes<std::uint8_t>(
        folder / "labels_u8.raw", nodes, box,
        [](std::uint8_t type) {
            return static_cast<std::uint8_t>(is_open(type) ? Label::fluid : Label::solid);
        },
        [](std::size_t) { return static_cast<std::uint8_t>(Label::device); });
    // A node without linear resistance is free fluid to LBPM.
    const auto drags = [&](std::size_t node) { return nodes.darcy[node] > 0.0; };
    write_nodes<double>(
        folder / "porosity_f64.raw", nodes, box, [](std::uint8_t) { return 1.0; },
        [&](std::size_t node) { return drags(node) ? device_porosity : 1.0; });
    const double area = nodes.grid.spacing * nodes.grid.spacing;
    write_nodes<double>(
        folder / "permeability_vox2_f64.raw", nodes, box, [](std::uint8_t) { return 1.0; },
        [&](std::size_t node) {
            return drags(node) ? device_porosity / (nodes.darcy[node] * area) : 1.0;
        });
    write_text_file(folder / "input.db",
                    input_text(box, between.faces.front().is_upper, units,
                               driving_density(nodes, vessel, box, units, flow)));
    const std::vector<int> shape = shape_of(box.dims());
    const char* order = "first index fastest";
    return {{"labels_u8.raw", "uint8", shape, order},
            {"porosity_f64.raw", "float64", shape, order},
            {"permeability_vox2_f64.raw", "float64 [node spacings squared]", shape, order},
            {"input.db", "text", {}, ""}};
}

}  // namespace braidzone

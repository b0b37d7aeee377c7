#include "export/braid_cells.hpp"

#include "deploy/deployment_measures.hpp"
#include "export/vtk_output.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace braidzone {

namespace {

template <typename Value>
std::vector<Value> at_points(const std::vector<Value>& of_nodes, const BraidLayout& layout)
{
    std::vector<Value> values;
    values.reserve(layout.node_of_point.size());
    for (const int node : layout.node_of_point) {
        values.push_back(of_nodes[static_cast<std::size_t>(node)]);
    }
    return values;
}

std::vector<Vec2> surface_coordinates(const BraidLattice& lattice)
{
    std::vector<Vec2> coordinates;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            coordinates.push_back(surface_coordinates(lattice, ring, column));
        }
    }
    return coordinates;
}

/// One number of each rhombus.
template <typename Value>
std::vector<double> of_rhombi(const BraidSurface& surface, Value value)
{
    std::vector<double> values;
    values.reserve(surface.rhombi.size());
    for (const Rhombus& rhombus : surface.rhombi)
        values.push_back(value(rhombus));
    return values;
}

std::vector<double> of_losses(const ResistanceSheet& sheet, double SheetLoss::*part)
{
    std::vector<double> values;
    values.reserve(sheet.losses.size());
    for (const SheetLoss& loss : sheet.losses)
        values.push_back(loss.*part);
    return values;
}

void add_point_fields(vtkPolyData& data, const BraidLayout& layout, const Deployment& deployment)
{
    vtkFieldData& fields = *data.GetPointData();
    add_flags(fields, "wall_contact", at_points(deployment.in_contact, layout));
    add_numbers(fields, "wall_distance", at_points(deployment.wall_distance, layout));
    add_numbers(fields, "contact_force", at_points(deployment.contact_force, layout));
    add_numbers(fields, "contact_pressure", at_points(deployment.contact_pressure, layout));
    add_numbers(fields, "radial_expansion", at_points(radial_expansion(deployment), layout));
    add_numbers(fields, "surface_coordinates",
                at_points(surface_coordinates(deployment.lattice), layout));
}

void add_cell_fields(vtkPolyData& data, const ResistanceSheet& sheet)
{
    const BraidSurface& surface = sheet.surface;
    vtkFieldData& fields = *data.GetCellData();
    add_numbers(fields, "metal_coverage",
                of_rhombi(surface, [](const Rhombus& r) { return r.metal_coverage; }));
    add_numbers(fields, "surface_porosity",
                of_rhombi(surface, [](const Rhombus& r) { return surface_porosity(r); }));
    add_numbers(fields, "surface_density_increase", surface.density_increase);
    add_numbers(fields, "pore_density",
                of_rhombi(surface, [](const Rhombus& r) { return r.pore_density; }));
    add_numbers(fields, "pore_area",
                of_rhombi(surface, [](const Rhombus& r) { return r.pore_area; }));
    add_numbers(fields, "inscribed_diameter",
                of_rhombi(surface, [](const Rhombus& r) { return r.inscribed_diameter; }));
    add_numbers(fields, "hydraulic_diameter",
                of_rhombi(surface, [](const Rhombus& r) { return r.hydraulic_diameter; }));
    add_numbers(fields, "wire_spacing_a",
                of_rhombi(surface, [](const Rhombus& r) { return r.spacing_a; }));
    add_numbers(fields, "wire_spacing_b",
                of_rhombi(surface, [](const Rhombus& r) { return r.spacing_b; }));
    add_numbers(fields, "densest_solidity",
                of_rhombi(surface, [](const Rhombus& r) { return densest_solidity(r); }));
    add_numbers(fields, "wire_length_per_area",
                of_rhombi(surface, [](const Rhombus& r) { return wire_length_per_area(r); }));
    add_numbers(fields, "metal_volume_per_area",
                of_rhombi(surface, [](const Rhombus& r) { return metal_volume_per_area(r); }));
    add_numbers(fields, "braid_angle",
                of_rhombi(surface, [](const Rhombus& r) { return r.braid_angle; }));
    add_numbers(fields, "crossing_angle",
                of_rhombi(surface, [](const Rhombus& r) { return r.crossing_angle; }));
    add_numbers(fields, "jamming_angle",
                of_rhombi(surface, [](const Rhombus& r) { return r.jamming_angle; }));
    add_numbers(fields, "pressure_loss_linear", of_losses(sheet, &SheetLoss::linear));
    add_numbers(fields, "pressure_loss_quadratic", of_losses(sheet, &SheetLoss::quadratic));
    add_numbers(fields, "resistance_acting", sheet.acting);
    add_numbers(fields, "contact_pressure", surface.contact_pressure);
    add_numbers(fields, "normal", surface.normals);
    data.GetCellData()->SetActiveScalars("metal_coverage");
}

const std::vector<ArrayUnit> array_units{{"wall_contact", "1"},
                                         {"wall_distance", "m"},
                                         {"contact_force", "N"},
                                         {"contact_pressure", "Pa"},
                                         {"radial_expansion", "m"},
                                         {"surface_coordinates", "m"},
                                         {"metal_coverage", "1"},
                                         {"surface_porosity", "1"},
                                         {"surface_density_increase", "1"},
                                         {"pore_density", "1/m^2"},
                                         {"pore_area", "m^2"},
                                         {"inscribed_diameter", "m"},
                                         {"hydraulic_diameter", "m"},
                                         {"wire_spacing_a", "m"},
                                         {"wire_spacing_b", "m"},
                                         {"densest_solidity", "1"},
                                         {"wire_length_per_area", "1/m"},
                                         {"metal_volume_per_area", "m"},
                                         {"braid_angle", "rad"},
                                         {"crossing_angle", "rad"},
                                         {"jamming_angle", "rad"},
                                         {"resistance_acting", "1"},
                                         {"pressure_loss_linear", "Pa s/m"},
                                         {"pressure_loss_quadratic", "Pa s^2/m^2"},
                                         {"normal", "1"}};

}  // namespace

BraidLayout deployed_layout(const Deployment& deployment, const BraidSurface& surface)
{
    BraidLayout layout{deployment.nodes, std::vector<int>(deployment.nodes.size()),
                       surface.corners};
    std::iota(layout.node_of_point.begin(), layout.node_of_point.end(), 0);
    return layout;
}

Vec2 surface_coordinates(const BraidLattice& lattice, int ring, int column)
{
    // In half node spacings, which are whole numbers: no rounding decides on which side of the cut
    // a node lies.
    const int half_turns = 2 * lattice.nodes_per_ring;
    const int around = ((2 * column + ring) % half_turns + half_turns) % half_turns;
    return {around * lattice.arm_width, ring * lattice.ring_spacing};
}

BraidLayout unrolled_layout(const BraidLattice& lattice)
{
    BraidLayout layout;
    const double circumference = 2.0 * std::numbers::pi * lattice.nominal_radius;
    // A node has a point for each of the two sides of the cut on which a rhombus needs it.
    std::map<std::pair<int, bool>, int> point_of_node;
    const auto point = [&](int node, double x, double y) {
        const bool beyond_cut =
            x < -0.25 * lattice.arm_width || x > circumference - 0.25 * lattice.arm_width;
        const auto [entry, is_new] =
            point_of_node.try_emplace({node, beyond_cut}, static_cast<int>(layout.points.size()));
        if (is_new) {
            layout.points.emplace_back(x, y, 0.0);
            layout.node_of_point.push_back(node);
        }
        return entry->second;
    };
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const std::array<int, 4> nodes = rhombus_corners(lattice, ring, column);
            const Vec2 first = surface_coordinates(lattice, ring, column);
            const double width = lattice.arm_width, height = lattice.ring_spacing;
            layout.corners.push_back({point(nodes[0], first[0], first[1]),
                                      point(nodes[1], first[0] - width, first[1] + height),
                                      point(nodes[2], first[0], first[1] + 2.0 * height),
                                      point(nodes[3], first[0] + width, first[1] + height)});
        }
    }
    return layout;
}

void write_braid_cells(const std::filesystem::path& path, const BraidLayout& layout,
                       const Deployment& deployment, const ResistanceSheet& sheet,
                       const LengthUnit& unit)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& point : layout.points) {
        points->InsertNextPoint((point / unit.metres).eval().data());
    }
    vtkNew<vtkCellArray> cells;
    for (const std::array<int, 4>& corners : layout.corners) {
        cells->InsertNextCell({corners[0], corners[1], corners[2], corners[3]});
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    add_point_fields(*data, layout, deployment);
    add_cell_fields(*data, sheet);
    add_units(*data, unit, array_units);
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_vtk_xml(path, *writer, *data);
}

}  // namespace braidzone

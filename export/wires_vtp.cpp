#include "export/wires_vtp.hpp"

#include "export/braid_cells.hpp"
#include "export/vtk_output.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace braidzone {

namespace {

/// Pieces of a wire between two crossings: enough that its bend looks round.
constexpr int pieces_per_arm = 4;

enum Family { right_handed = 0, left_handed = 1 };

/// Column of a wire's crossing in a ring: right-handed wires pass from (k, j) to (k+1, j-1),
/// left-handed ones from (k, j) to (k+1, j).
int column_of_wire(const BraidLattice& lattice, Family family, int wire, int ring)
{
    if (family == left_handed) return wire;
    const int n = lattice.nodes_per_ring;
    return ((wire - ring) % n + n) % n;
}

/// Catmull-Rom spline between p1 and p2 (Catmull and Rom 1974), t from 0 to 1.
Vec3 catmull_rom(const Vec3& p0, const Vec3& p1, const Vec3& p2, const Vec3& p3, double t)
{
    return 0.5 * (2.0 * p1 + t * (p2 - p0 +
                                  t * (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3 +
                                       t * (3.0 * p1 - p0 - 3.0 * p2 + p3))));
}

struct WirePoint {
    Vec3 position = Vec3::Zero();             ///< [m]
    Vec2 surface_coordinates = Vec2::Zero();  ///< [m]
};

std::vector<WirePoint> trace_wire(const Deployment& deployment, Family family, int wire)
{
    const BraidLattice& lattice = deployment.lattice;
    const int last = lattice.num_rings - 1;
    const auto crossing = [&](int ring) -> const Vec3& {
        return deployment.nodes[static_cast<std::size_t>(
            lattice.node(ring, column_of_wire(lattice, family, wire, ring)))];
    };
    // Before the first and after the last crossing the wire goes on straight.
    const auto crossing_or_beyond = [&](int ring) -> Vec3 {
        if (ring < 0) return 2.0 * crossing(0) - crossing(1);
        if (ring > last) return 2.0 * crossing(last) - crossing(last - 1);
        return crossing(ring);
    };
    const double circumference = 2.0 * std::numbers::pi * lattice.nominal_radius;
    const double step_around = family == right_handed ? -lattice.arm_width : lattice.arm_width;

    std::vector<WirePoint> points;
    for (int ring = 0; ring <= last; ++ring) {
        const Vec2 start =
            surface_coordinates(lattice, ring, column_of_wire(lattice, family, wire, ring));
        const int pieces = ring < last ? pieces_per_arm : 1;
        for (int piece = 0; piece < pieces; ++piece) {
            const double t = static_cast<double>(piece) / pieces_per_arm;
            const double around = start[0] + t * step_around;
            points.push_back(
                {catmull_rom(crossing_or_beyond(ring - 1), crossing(ring),
                             crossing_or_beyond(ring + 1), crossing_or_beyond(ring + 2), t),
                 {around < 0.0 ? around + circumference : around,
                  start[1] + t * lattice.ring_spacing}});
        }
    }
    return points;
}

}  // namespace

void write_wires(const std::filesystem::path& path, const Deployment& deployment,
                 double wire_diameter, const LengthUnit& unit)
{
    const int wires_per_family = deployment.lattice.nodes_per_ring;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    std::vector<Vec2> coordinates;
    std::vector<int> wire_ids, families;
    for (const Family family : {right_handed, left_handed}) {
        for (int wire = 0; wire < wires_per_family; ++wire) {
            const std::vector<WirePoint> trace = trace_wire(deployment, family, wire);
            lines->InsertNextCell(static_cast<int>(trace.size()));
            for (const WirePoint& point : trace) {
                lines->InsertCellPoint(
                    points->InsertNextPoint((point.position / unit.metres).eval().data()));
                coordinates.push_back(point.surface_coordinates);
            }
            wire_ids.push_back(family * wires_per_family + wire);
            families.push_back(family);
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    add_numbers(*data->GetPointData(), "radius",
                std::vector<double>(coordinates.size(), 0.5 * wire_diameter / unit.metres));
    add_numbers(*data->GetPointData(), "surface_coordinates", coordinates);
    add_integers(*data->GetCellData(), "wire", wire_ids);
    add_integers(*data->GetCellData(), "family", families);
    add_units(
        *data, unit,
        {{"radius", unit.name}, {"surface_coordinates", "m"}, {"wire", "1"}, {"family", "1"}});
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_vtk_xml(path, *writer, *data);
}

}  // namespace braidzone

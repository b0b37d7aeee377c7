#include "export/wires_vtp.hpp"

#include "export/vtk_output.hpp"
#include "export/wire_path.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <vector>

namespace braidzone {

namespace {

/// Pieces of a wire between two crossings: enough that its bend looks round.
constexpr int pieces_per_arm = 4;

}  // namespace

void write_wires(const std::filesystem::path& path, const Deployment& deployment,
                 double wire_diameter, const LengthUnit& unit)
{
    const BraidLattice& lattice = deployment.lattice;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    std::vector<Vec2> coordinates;
    std::vector<int> wire_ids, families;
    for (const Wire wire : wires_of(lattice)) {
        const std::vector<Vec3> trace =
            spline_along_wire(lattice, deployment.nodes, wire, pieces_per_arm);
        const std::vector<Vec2> on_surface =
            surface_coordinates_along_wire(lattice, wire, pieces_per_arm);
        lines->InsertNextCell(static_cast<int>(trace.size()));
        for (const Vec3& point : trace)
            lines->InsertCellPoint(points->InsertNextPoint((point / unit.metres).eval().data()));
        coordinates.insert(coordinates.end(), on_surface.begin(), on_surface.end());
        wire_ids.push_back(static_cast<int>(wire_ids.size()));
        families.push_back(static_cast<int>(wire.family));
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    add_numbers(*data->GetPointData(), "radius",
                std::vector<double>(coordinates.size(), 0.5 * wire_diameter / unit.metres));
    add_numbers(*data->GetPointData(), "surface_coordinates", coordinates);
    add_integers(*data->GetCellData(), "wire", wire_ids);
    add_integers(*data->GetCellData(), "family", families);
    data->GetCellData()->SetActiveScalars("family");
    add_units(
        *data, unit,
        {{"radius", unit.name}, {"surface_coordinates", "m"}, {"wire", "1"}, {"family", "1"}});
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_vtk_xml(path, *writer, *data);
}

}  // namespace braidzone

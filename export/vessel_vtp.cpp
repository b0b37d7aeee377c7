#include "export/vessel_vtp.hpp"

#include "export/vtk_output.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace braidzone {

void write_vessel_vtp(const std::filesystem::path& path, const Vessel& vessel)
{
    const ClosedLumen lumen = close_openings(vessel);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& point : lumen.mesh.points)
        points->InsertNextPoint((point / vessel.unit.metres).eval().data());
    vtkNew<vtkCellArray> cells;
    for (const auto& [a, b, c] : lumen.mesh.triangles)
        cells->InsertNextCell({a, b, c});
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    add_integers(*data->GetCellData(), "opening", lumen.opening_of);
    data->GetCellData()->SetActiveScalars("opening");
    add_units(*data, vessel.unit, {{"opening", "1"}});
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_vtk_xml(path, *writer, *data);
}

}  // namespace braidzone

#include "export/frames_vtp.hpp"

#include "core/error.hpp"
#include "export/vtk_output.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <fstream>

namespace braidzone {

namespace {

void write_frame(const std::filesystem::path& path, const BraidLattice& lattice, const Frame& frame,
                 const LengthUnit& unit)
{
    if (frame.nodes.size() != static_cast<std::size_t>(lattice.num_nodes())) {
        throw InputError(fmt::format("the frame of step {} has {} nodes; the lattice has {}",
                                     frame.step, frame.nodes.size(), lattice.num_nodes()));
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    std::vector<char> released;
    for (int node = 0; node < lattice.num_nodes(); ++node) {
        points->InsertNextPoint(
            (frame.nodes[static_cast<std::size_t>(node)] / unit.metres).eval().data());
        released.push_back(node / lattice.nodes_per_ring < frame.num_released);
    }
    vtkNew<vtkCellArray> cells;
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const auto [a, b, c, d] = rhombus_corners(lattice, ring, column);
            cells->InsertNextCell({a, b, c, d});
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    add_flags(*data->GetPointData(), "released", released);
    data->GetPointData()->SetActiveScalars("released");
    add_integers(*data->GetFieldData(), "step", {frame.step});
    add_units(*data, unit, {{"released", "1"}, {"step", "1"}});
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_vtk_xml(path, *writer, *data);
}

}  // namespace

void write_frames(const std::filesystem::path& collection, const BraidLattice& lattice,
                  const std::vector<Frame>& frames, const LengthUnit& unit)
{
    const std::filesystem::path name = collection.stem(), folder = collection.parent_path();
    std::error_code error;
    std::filesystem::create_directories(folder / name, error);
    if (error) {
        throw IoError(
            fmt::format("{}: cannot be made: {}", (folder / name).string(), error.message()));
    }
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <!-- timestep: steps since the first release -->\n"
        "  <Collection>\n";
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::filesystem::path file = name / fmt::format("frame_{:04}.vtp", i);
        write_frame(folder / file, lattice, frames[i], unit);
        text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n",
                            frames[i].step, file.string());
    }
    text += "  </Collection>\n</VTKFile>\n";
    std::ofstream file(collection);
    file << text;
    if (!file.flush()) throw IoError(fmt::format("{}: cannot be written", collection.string()));
}

}  // namespace braidzone

#include "cli/discrepancy_vtp.hpp"

#include "export/vtk_output.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace braidzone {
namespace {

/// The patch that each crossing lies in; -1 for none.
std::vector<int> patch_of_nodes(const Deployment& deployment, const DiscrepancyField& field)
{
    std::map<std::pair<int, int>, int> patch_at;
    for (std::size_t i = 0; i < field.patches.size(); ++i)
        patch_at[{field.patches[i].row, field.patches[i].column}] = static_cast<int>(i);
    std::vector<int> patches;
    const int n = deployment.lattice.nodes_per_ring;
    for (std::size_t node = 0; node < deployment.nodes.size(); ++node) {
        const auto ring = node / static_cast<std::size_t>(n);
        const auto [row, column] =
            patch_place(deployment.ring_arc_length[ring],
                        angle_about(deployment.rings[ring], deployment.nodes[node]), field.options);
        const auto found = patch_at.find({row, column});
        patches.push_back(found == patch_at.end() ? -1 : found->second);
    }
    return patches;
}

void add_field(vtkPolyData& data, const std::string& name, const Eigen::VectorXd& values,
               const std::vector<int>& patch_of_node)
{
    std::vector<double> numbers;
    for (const int patch : patch_of_node)
        numbers.push_back(patch < 0 ? std::numeric_limits<double>::quiet_NaN() : values[patch]);
    add_numbers(*data.GetPointData(), name, numbers);
}

}  // namespace

void write_discrepancy_vtp(const std::filesystem::path& path, const Diagnosis& diagnosis,
                           const LengthUnit& unit)
{
    const Deployment& deployment = diagnosis.base.deployment;
    const BraidLattice& lattice = deployment.lattice;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& node : deployment.nodes)
        points->InsertNextPoint((node / unit.metres).eval().data());
    vtkNew<vtkCellArray> cells;
    for (int ring = 0; ring + 2 < lattice.num_rings; ++ring) {
        for (int column = 0; column < lattice.nodes_per_ring; ++column) {
            const auto corners = rhombus_corners(lattice, ring, column);
            cells->InsertNextCell({corners[0], corners[1], corners[2], corners[3]});
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    const std::vector<int> patches = patch_of_nodes(deployment, diagnosis.observations.field);
    add_field(*data, "gap_before", diagnosis.map.gap, patches);
    std::vector<ArrayUnit> units = {{"gap_before", "m"}, {"unexplained", "m"}, {"t_before", "1"}};
    if (diagnosis.map_after) {
        add_field(*data, "gap_after", diagnosis.map_after->gap, patches);
        units.push_back({"gap_after", "m"});
    }
    add_field(*data, "unexplained", diagnosis.explanation.unexplained, patches);
    add_field(*data, "t_before", diagnosis.map.t, patches);
    add_units(*data, unit, units);
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_vtk_xml(path, *writer, *data);
}

}  // namespace braidzone

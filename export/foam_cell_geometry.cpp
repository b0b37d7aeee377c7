#include "export/foam_cell_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace braidzone {

namespace {

/// OpenFOAM's VSMALL: below it a face or cell counts as empty.
constexpr double smallest = std::numeric_limits<double>::min();

struct FaceGeometry {
    Vec3 centre = Vec3::Zero();  ///< [m]
    Vec3 area = Vec3::Zero();    ///< along the face's normal [m^2]
};

FaceGeometry measure_face(const std::vector<Vec3>& points, const std::vector<int>& face)
{
    const auto corner = [&](std::size_t i) -> const Vec3& {
        return points[static_cast<std::size_t>(face[i % face.size()])];
    };
    if (face.size() == 3) {
        const Vec3 &a = corner(0), &b = corner(1), &c = corner(2);
        return {(a + b + c) / 3.0, 0.5 * (b - a).cross(c - a)};
    }
    Vec3 apex = Vec3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i)
        apex += corner(i);
    apex /= static_cast<double>(face.size());

    Vec3 twice_area = Vec3::Zero(), moment = Vec3::Zero();
    double sum = 0.0;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 normal = (corner(i + 1) - corner(i)).cross(apex - corner(i));
        twice_area += normal;
        sum += normal.norm();
        moment += normal.norm() * (corner(i) + corner(i + 1) + apex);
    }
    if (sum < smallest) return {apex, Vec3::Zero()};
    return {moment / (3.0 * sum), 0.5 * twice_area};
}

}  // namespace

Vec3 face_area(const FoamMesh& mesh, std::size_t face)
{
    return measure_face(mesh.points, mesh.faces[face]).area;
}

void compute_cell_geometry(FoamMesh& mesh)
{
    std::vector<FaceGeometry> faces;
    faces.reserve(mesh.faces.size());
    for (const auto& face : mesh.faces)
        faces.push_back(measure_face(mesh.points, face));

    const auto size = static_cast<std::size_t>(count_cells(mesh));

    // Each face with the cells beside it; `sign` is -1 where its normal points into the cell.
    const auto for_each_side = [&](auto visit) {
        for (std::size_t f = 0; f < faces.size(); ++f)
            visit(static_cast<std::size_t>(mesh.owner[f]), faces[f], 1.0);
        for (std::size_t f = 0; f < mesh.neighbour.size(); ++f)
            visit(static_cast<std::size_t>(mesh.neighbour[f]), faces[f], -1.0);
    };

    std::vector<Vec3> apex(size, Vec3::Zero());
    std::vector<int> num_faces(size, 0);
    for_each_side([&](std::size_t cell, const FaceGeometry& face, double) {
        apex[cell] += face.centre;
        ++num_faces[cell];
    });
    for (std::size_t cell = 0; cell < size; ++cell)
        apex[cell] /= num_faces[cell];

    mesh.cell_volumes.assign(size, 0.0);
    mesh.cell_centres.assign(size, Vec3::Zero());
    for_each_side([&](std::size_t cell, const FaceGeometry& face, double sign) {
        const double pyramid = sign * face.area.dot(face.centre - apex[cell]) / 3.0;
        mesh.cell_volumes[cell] += pyramid;
        mesh.cell_centres[cell] += pyramid * (0.75 * face.centre + 0.25 * apex[cell]);
    });
    for (std::size_t cell = 0; cell < size; ++cell) {
        if (std::abs(mesh.cell_volumes[cell]) > smallest)
            mesh.cell_centres[cell] /= mesh.cell_volumes[cell];
        else
            mesh.cell_centres[cell] = apex[cell];
    }
}

}  // namespace braidzone

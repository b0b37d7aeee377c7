#pragma once

#include "export/foam_mesh.hpp"

#include <memory>
#include <vector>

namespace braidzone {

/// For each cell, the cells with which it shares a face, in the order of the faces.
std::vector<std::vector<int>> cell_neighbours(const FoamMesh& mesh);

/// Finds the cell whose centre is nearest to a point (CGAL's k-d tree).
class CellSearch {
public:
    explicit CellSearch(const FoamMesh& mesh);
    ~CellSearch();
    CellSearch(CellSearch&&) noexcept;
    CellSearch& operator=(CellSearch&&) noexcept;

    int nearest(const Vec3& point) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace braidzone

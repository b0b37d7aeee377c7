#include "export/foam_cell_search.hpp"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <tuple>

namespace braidzone {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using PointAndCell = std::tuple<Kernel::Point_3, int>;
using Traits =
    CGAL::Search_traits_adapter<PointAndCell, CGAL::Nth_of_tuple_property_map<0, PointAndCell>,
                                CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

Kernel::Point_3 to_cgal(const Vec3& p)
{
    return {p.x(), p.y(), p.z()};
}

}  // namespace

struct CellSearch::Impl {
    Search::Tree tree;
};

CellSearch::CellSearch(const FoamMesh& mesh) : impl_(std::make_unique<Impl>())
{
    for (int cell = 0; cell < mesh.num_cells(); ++cell)
        impl_->tree.insert(
            PointAndCell(to_cgal(mesh.cell_centres[static_cast<std::size_t>(cell)]), cell));
    impl_->tree.build();
}

CellSearch::~CellSearch() = default;
CellSearch::CellSearch(CellSearch&&) noexcept = default;
CellSearch& CellSearch::operator=(CellSearch&&) noexcept = default;

int CellSearch::nearest(const Vec3& point) const
{
    const Search search(impl_->tree, to_cgal(point), 1);
    return std::get<1>(search.begin()->first);
}

std::vector<std::vector<int>> cell_neighbours(const FoamMesh& mesh)
{
    std::vector<std::vector<int>> neighbours(mesh.cell_volumes.size());
    for (std::size_t face = 0; face < mesh.neighbour.size(); ++face) {
        const int a = mesh.owner[face], b = mesh.neighbour[face];
        neighbours[static_cast<std::size_t>(a)].push_back(b);
        neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    return neighbours;
}

}  // namespace braidzone

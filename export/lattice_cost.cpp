#include "export/lattice_cost.hpp"

#include "core/error.hpp"
#include "export/lattice_nodes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <system_error>

namespace braidzone {

namespace {

constexpr double memory_a_node = 1.3;         // [bytes]
constexpr double memory_a_wall_piece = 60.0;  // of a spacing squared [bytes]
constexpr double gigabyte = 1e9;

}  // namespace

LatticeCost lattice_cost(const Vessel& vessel, double spacing,
                         const std::vector<LatticeTarget>& targets)
{
    LatticeCost cost;
    cost.spacing = spacing;
    const Vec3 dims = lattice_dims(vessel, spacing);
    cost.dims = {dims[0], dims[1], dims[2]};
    cost.memory = memory_a_node * cost.num_nodes() +
                  memory_a_wall_piece * surface_area(vessel.wall) / (spacing * spacing);
    for (const LatticeTarget target : targets)
        cost.disk += traits_of(target).bytes_a_node * cost.num_nodes();
    return cost;
}

LatticeRoom room_at(const std::filesystem::path& folder)
{
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(folder, error);
    if (error) {
        throw IoError(fmt::format("{}: free space cannot be determined: {}", folder.string(),
                                  error.message()));
    }
    const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
    return {page * static_cast<double>(::sysconf(_SC_PHYS_PAGES)),
            static_cast<double>(space.available)};
}

void require_room(const LatticeCost& cost, const LatticeRoom& room)
{
    if (!(cost.num_nodes() <= most_lattice_nodes)) {
        const double fitting = cost.spacing * std::cbrt(cost.num_nodes() / most_lattice_nodes);
        throw ConfigError(fmt::format(
            "grid.spacing = {:.4g} mm gives a lattice of {}; at most {:.3g} nodes are allowed, as "
            "with a spacing of {:.3g} mm",
            1e3 * cost.spacing, describe(cost), most_lattice_nodes, 1e3 * fitting));
    }
    if (!(cost.memory <= room.memory)) {
        // Both parts shrink at least with the square of the spacing.
        const double fitting = cost.spacing * std::sqrt(cost.memory / room.memory);
        throw ConfigError(fmt::format(
            "grid.spacing = {:.4g} mm gives a lattice of {}; the machine has {:.3g} GB; a spacing "
            "of {:.3g} mm fits",
            1e3 * cost.spacing, describe(cost), room.memory / gigabyte, 1e3 * fitting));
    }
    if (!(cost.disk <= room.disk)) {
        throw IoError(fmt::format(
            "grid.spacing = {:.4g} mm gives a lattice of {}; {:.3g} GB are free there; take a "
            "wider spacing, fewer targets, or another --output",
            1e3 * cost.spacing, describe(cost), room.disk / gigabyte));
    }
}

std::string describe(const LatticeCost& cost)
{
    return fmt::format(
        "{:.0f} x {:.0f} x {:.0f} = {:.3g} nodes, {:.2g} GB of memory, {:.2g} GB of disk",
        cost.dims[0], cost.dims[1], cost.dims[2], cost.num_nodes(), cost.memory / gigabyte,
        cost.disk / gigabyte);
}

}  // namespace braidzone

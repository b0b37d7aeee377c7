#include "export/lattice_targets.hpp"

#include <algorithm>
#include <iterator>

namespace braidzone {

namespace {

constexpr TargetTraits targets[] = {
    {.target = LatticeTarget::numpy,
     .name = "numpy",
     .has_linear = true,
     .quadratic_limit = nullptr,
     .has_normal = true,
     .flat_openings = nullptr,
     .bytes_a_node = 1 + 5 * 4},
    {.target = LatticeTarget::openlb,
     .name = "openlb",
     .has_linear = true,
     .quadratic_limit = "the linear part of the resistance only",
     .has_normal = false,
     .flat_openings = nullptr,
     .bytes_a_node = 7},
    {.target = LatticeTarget::palabos,
     .name = "palabos",
     .has_linear = false,
     .quadratic_limit = nullptr,
     .has_normal = false,
     .flat_openings = nullptr,
     .bytes_a_node = 2},
    {.target = LatticeTarget::walberla,
     .name = "walberla",
     .has_linear = false,
     .quadratic_limit = nullptr,
     .has_normal = false,
     .flat_openings = nullptr,
     .bytes_a_node = 1},
    {.target = LatticeTarget::hemoflow,
     .name = "hemoflow",
     .has_linear = true,
     .quadratic_limit = "the quadratic part in one ratio to the linear one, on each component of "
                        "the velocity by itself",
     .has_normal = false,
     .flat_openings = "extended",
     .bytes_a_node = 0.1},  // compressed
    {.target = LatticeTarget::lbpm,
     .name = "lbpm",
     .has_linear = true,
     .quadratic_limit = "no quadratic part of the resistance but has one of its own",
     .has_normal = false,
     .flat_openings = "extended_z",
     .bytes_a_node = 1 + 2 * 8},
};

}  // namespace

const TargetTraits& traits_of(LatticeTarget target)
{
    return *std::find_if(std::begin(targets), std::end(targets),
                         [&](const TargetTraits& traits) { return traits.target == target; });
}

std::string target_name(LatticeTarget target)
{
    return traits_of(target).name;
}

std::vector<LatticeTarget> all_lattice_targets()
{
    std::vector<LatticeTarget> all;
    for (const TargetTraits& traits : targets)
        all.push_back(traits.target);
    return all;
}

std::vector<LatticeTarget> default_lattice_targets()
{
    std::vector<LatticeTarget> of_any_vessel = all_lattice_targets();
    std::erase_if(of_any_vessel,
                  [](LatticeTarget target) { return traits_of(target).flat_openings != nullptr; });
    return of_any_vessel;
}

}  // namespace braidzone

#pragma once

#include "support/d3q19.hpp"

#include <array>
#include <cstddef>

namespace braidzone::test {

/// Cells that collide together.
constexpr std::size_t chunk_width = 64;
using Lane = std::array<float, chunk_width>;

/// Populations and moments of a chunk. Loops over its cells are innermost and on arrays that
/// nothing else refers to, so that compilers vectorise them.
struct Chunk {
    std::array<Lane, d3q19::num_velocities> populations;
    Lane density;
    std::array<Lane, 3> velocity;  ///< the momentum until half the force is added
    std::array<Lane, 3> force;
};

/// Relaxation rates of the even and odd parts of the populations:
///
///     tau+ = 3 nu + 1/2,   (tau+ - 1/2) (tau- - 1/2) = 3/16
///
/// With this product, halfway walls of a channel along the lattice stay where they are whatever the
/// viscosity (Ginzburg, Verhaeghe and d'Humieres 2008, Commun. Comput. Phys. 3:427).
struct TrtRates {
    float even = 1.0F;
    float odd = 1.0F;
};

inline TrtRates trt_rates(double viscosity_lu)
{
    constexpr double magic_parameter = 3.0 / 16.0;
    const double even_time = 3.0 * viscosity_lu + 0.5;
    const double odd_time = 0.5 + magic_parameter / (even_time - 0.5);
    return {static_cast<float>(1.0 / even_time), static_cast<float>(1.0 / odd_time)};
}

/// Velocity 2 pair + 1 as numbers.
inline std::array<float, 3> pair_velocity(std::size_t pair)
{
    const auto& c = d3q19::velocity[2 * pair + 1];
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

/// Density and momentum of the first `num_cells` cells, from their populations.
inline void sum_moments(Chunk& chunk, std::size_t num_cells)
{
    for (std::size_t j = 0; j < num_cells; ++j) {
        chunk.density[j] = chunk.populations[0][j];
        for (Lane& component : chunk.velocity)
            component[j] = 0.0F;
    }
    for (std::size_t pair = 0; pair < d3q19::num_pairs; ++pair) {
        const Lane &forth = chunk.populations[2 * pair + 1],
                   &back = chunk.populations[2 * pair + 2];
        const auto [cx, cy, cz] = pair_velocity(pair);
        for (std::size_t j = 0; j < num_cells; ++j) {
            chunk.density[j] += forth[j] + back[j];
            const float difference = forth[j] - back[j];
            chunk.velocity[0][j] += cx * difference;
            chunk.velocity[1][j] += cy * difference;
            chunk.velocity[2][j] += cz * difference;
        }
    }
}

/// Collides the first `num_cells` cells. The equilibrium of a pair's even and odd parts is
///
///     w (rho + 9/2 (c u)^2 - 3/2 u^2)   and   3 w c u
///
/// (He and Luo 1997, doi 10.1023/B:JOSS.0000015179.12689.e4), in Stokes flow without the squares;
/// force F adds w (1 - omega+ / 2) (9 (c u)(c F) - 3 u F) and 3 w (1 - omega- / 2) c F (Guo, Zheng
/// and Shi 2002, doi 10.1103/PhysRevE.65.046308).
/// @tparam inertia  Navier-Stokes; else Stokes flow
template <bool inertia>
void collide(Chunk& chunk, std::size_t num_cells, const TrtRates& rates)
{
    const auto [even, odd] = rates;
    const float even_force = 1.0F - 0.5F * even, odd_force = 1.0F - 0.5F * odd;
    const std::array<Lane, 3>&u = chunk.velocity, &force = chunk.force;

    Lane squared, power;  // 3/2 u^2 and 3 u F
    for (std::size_t j = 0; j < num_cells; ++j) {
        squared[j] = power[j] = 0.0F;
        if constexpr (inertia) {
            squared[j] = 1.5F * (u[0][j] * u[0][j] + u[1][j] * u[1][j] + u[2][j] * u[2][j]);
            power[j] =
                3.0F * (u[0][j] * force[0][j] + u[1][j] * force[1][j] + u[2][j] * force[2][j]);
        }
    }
    Lane& rest = chunk.populations[0];
    for (std::size_t j = 0; j < num_cells; ++j) {
        rest[j] += even * (d3q19::rest_weight * (chunk.density[j] - squared[j]) - rest[j]) -
                   even_force * d3q19::rest_weight * power[j];
    }
    for (std::size_t pair = 0; pair < d3q19::num_pairs; ++pair) {
        Lane &forth = chunk.populations[2 * pair + 1], &back = chunk.populations[2 * pair + 2];
        const auto [cx, cy, cz] = pair_velocity(pair);
        const float weight = d3q19::pair_weight(pair);
        for (std::size_t j = 0; j < num_cells; ++j) {
            const float cu = cx * u[0][j] + cy * u[1][j] + cz * u[2][j];
            const float cf = cx * force[0][j] + cy * force[1][j] + cz * force[2][j];
            const float mean = 0.5F * (forth[j] + back[j]);
            const float half = 0.5F * (forth[j] - back[j]);
            float even_equilibrium = chunk.density[j], even_source = 0.0F;
            if constexpr (inertia) {
                even_equilibrium += 4.5F * cu * cu - squared[j];
                even_source = even_force * (9.0F * cu * cf - power[j]);
            }
            const float even_part =
                mean + even * (weight * even_equilibrium - mean) + weight * even_source;
            const float odd_part = half + 3.0F * weight * (odd * cu + odd_force * cf) - odd * half;
            forth[j] = even_part + odd_part;
            back[j] = even_part - odd_part;
        }
    }
}

}  // namespace braidzone::test

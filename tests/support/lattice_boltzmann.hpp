#pragma once

#include "support/d3q19.hpp"
#include "support/lattice_walls.hpp"
#include "support/periodic_box.hpp"
#include "support/round_wires.hpp"
#include "support/trt_collision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace braidzone::test {

/// What flows in a `LatticeFlow`. Its density is 1.
struct LatticeFluid {
    double viscosity_lu = 0.5;  ///< kinematic; > 0
    bool inertia = false;       ///< Navier-Stokes; else Stokes flow
};

/// A cell with the momentum sink S = -(nu D + 1/2 F |U|) U, where D = D_n n n^T + D_t (I - n n^T)
/// and F alike.
struct DragCell {
    std::array<int, 3> cell{};
    double darcy_normal_lu = 0.0;
    double darcy_tangential_lu = 0.0;
    double forchheimer_normal_lu = 0.0;
    double forchheimer_tangential_lu = 0.0;
    Vec3 normal = Vec3::UnitZ();  ///< n, unit
};

/// Flow in a triply periodic box around round wires or other walls and through cells with drag, by
/// the lattice Boltzmann method in lattice units: cell spacing, time step and density are 1.
///
/// D3Q19 with two relaxation times (`trt_collision.hpp`), no slip on the wires by central linear
/// interpolation along each link (`lattice_walls.hpp`). Together they make steady Stokes flow
/// independent of the viscosity in lattice units, which Bouzidi's interpolation does not. Drag is
/// implicit in the velocity; |U| in it is that of the step before, which steady states do not
/// notice.
///
/// In the steady state the pressure drop balances the body force: over a period L along the force,
/// dp = rho g L.
///
/// The fluid starts at rest. Populations are deviations from those at rest, in single precision.
class LatticeFlow {
public:
    LatticeFlow(const PeriodicBox& box, const LatticeFluid& lattice_fluid,
                const std::vector<RoundWire>& wires = {}, const std::vector<DragCell>& drag = {})
        : LatticeFlow(box, lattice_walls(box, with_images(wires, box)), lattice_fluid, drag)
    {
    }

    LatticeFlow(const PeriodicBox& box, LatticeWalls walls, const LatticeFluid& lattice_fluid,
                const std::vector<DragCell>& drag)
        : fluid(lattice_fluid),
          forced_planes{0, box.dims[2]},
          box_(box),
          size_(box.array_size()),
          populations_(static_cast<std::size_t>(d3q19::num_velocities * size_), 0.0F),
          next_(populations_),
          walls_(std::move(walls)),
          drag_of_cell_(drag.empty() ? 0 : static_cast<std::size_t>(size_), -1)
    {
        find_ghosts();
        for (const DragCell& cell : drag) {
            drag_of_cell_[static_cast<std::size_t>(box.index(cell.cell))] =
                static_cast<std::int32_t>(drag_.size());
            drag_.push_back({.coefficients = cell});
        }
    }

    LatticeFluid fluid;
    Vec3 body_force = Vec3::Zero();    ///< on every fluid cell of the forced planes, per mass
    std::array<int, 2> forced_planes;  ///< first z and end; all at the start

    const PeriodicBox& box() const { return box_; }

    void step()
    {
        reflect_at_walls();
        fill_ghosts();
        constexpr int width = static_cast<int>(chunk_width);
        for (const FluidSpan& span : walls_.spans) {
            for (int first = 0; first < span.length; first += width) {
                stream_and_collide(span.start + first, std::min(width, span.length - first),
                                   is_forced(span) ? body_force : Vec3::Zero());
            }
        }
        populations_.swap(next_);
    }

    /// Adds mass to a cell: a source, or a sink if negative.
    void add_density(const std::array<int, 3>& cell, double density)
    {
        const std::ptrdiff_t index = box_.index(cell);
        for (int i = 0; i < d3q19::num_velocities; ++i) {
            of(populations_, i)[index] += d3q19::weight(i) * static_cast<float>(density);
        }
    }

    /// Deviation of the density from 1: three times the pressure.
    double density(const std::array<int, 3>& cell) const
    {
        const std::ptrdiff_t index = box_.index(cell);
        float sum = 0.0F;
        for (int i = 0; i < d3q19::num_velocities; ++i)
            sum += of(populations_, i)[index];
        return static_cast<double>(sum);
    }

    /// Part of the box on which the body force acts.
    double forced_fraction() const
    {
        double num_cells = 0.0;
        for (const FluidSpan& span : walls_.spans) {
            if (is_forced(span)) num_cells += span.length;
        }
        return num_cells / box_.num_cells();
    }

    /// Mean velocity over the box, wires and all.
    Vec3 superficial_velocity() const
    {
        Vec3 sum = Vec3::Zero();
        for (const FluidSpan& span : walls_.spans)
            sum += velocity_sum(span);
        for (const Drag& drag : drag_)
            sum -= 0.5 * drag.sink;
        return sum / box_.num_cells();
    }

    /// Mean velocity over the cells with this z, of which none has drag.
    Vec3 plane_velocity(int z) const
    {
        Vec3 sum = Vec3::Zero();
        for (const FluidSpan& span : walls_.spans) {
            if (span.z == z) sum += velocity_sum(span);
        }
        return sum / (1.0 * box_.dims[0] * box_.dims[1]);
    }

private:
    struct Drag {
        DragCell coefficients;
        double speed = 0.0;        ///< of the last step
        Vec3 sink = Vec3::Zero();  ///< S of the last step
    };

    float* of(std::vector<float>& populations, int i) const
    {
        return populations.data() + i * size_;
    }
    const float* of(const std::vector<float>& populations, int i) const
    {
        return populations.data() + i * size_;
    }

    /// From the index of a cell to that of its neighbour along velocity i.
    std::ptrdiff_t index_step(int i) const
    {
        return box_.index(d3q19::moved({0, 0, 0}, i)) - box_.index({0, 0, 0});
    }

    bool is_forced(const FluidSpan& span) const
    {
        return span.z >= forced_planes[0] && span.z < forced_planes[1];
    }

    /// The ghost cells from which cells of the box receive population i, and what they are.
    void find_ghosts()
    {
        for (int i = 1; i < d3q19::num_velocities; ++i) {
            auto& copies = ghosts_[static_cast<std::size_t>(i)];
            box_.for_each_cell([&](const std::array<int, 3>& cell) {
                const std::array<int, 3> from = d3q19::moved(cell, d3q19::opposite(i));
                const std::array<int, 3> original = box_.wrapped(from);
                if (original != from) copies.emplace_back(box_.index(from), box_.index(original));
            });
        }
    }

    /// Puts what comes back from walls where streaming fetches it.
    void reflect_at_walls()
    {
        for (const WallLink& link : walls_.links) {
            const float* const out = of(populations_, link.out);
            float* const in = of(populations_, d3q19::opposite(link.out));
            in[link.wall_cell] =
                out[link.cell] + link.factor * (out[link.cell_behind] - in[link.cell]);
        }
    }

    void fill_ghosts()
    {
        for (int i = 1; i < d3q19::num_velocities; ++i) {
            float* const population = of(populations_, i);
            for (const auto& [ghost, original] : ghosts_[static_cast<std::size_t>(i)])
                population[ghost] = population[original];
        }
    }

    void stream_and_collide(std::ptrdiff_t start, int count, const Vec3& body)
    {
        const auto num_cells = static_cast<std::size_t>(count);
        Chunk chunk;
        for (int i = 0; i < d3q19::num_velocities; ++i) {
            const float* from = of(populations_, i) + start - index_step(i);
            std::copy_n(from, num_cells, chunk.populations[static_cast<std::size_t>(i)].data());
        }
        sum_moments(chunk, num_cells);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::fill_n(chunk.force[axis].data(), num_cells,
                        static_cast<float>(body[static_cast<int>(axis)]));
        }
        if (!drag_.empty()) add_drag(start, num_cells, chunk);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t j = 0; j < num_cells; ++j)
                chunk.velocity[axis][j] += 0.5F * chunk.force[axis][j];
        }
        const TrtRates rates = trt_rates(fluid.viscosity_lu);
        if (fluid.inertia) {
            collide<true>(chunk, num_cells, rates);
        } else {
            collide<false>(chunk, num_cells, rates);
        }
        for (int i = 0; i < d3q19::num_velocities; ++i) {
            std::copy_n(chunk.populations[static_cast<std::size_t>(i)].data(), num_cells,
                        of(next_, i) + start);
        }
    }

    /// Adds the sink S to the force g. With U = momentum + (g + S) / 2, each part of U, along and
    /// across the normal, is that of momentum + g / 2 over 1 + 1/2 (nu D + 1/2 F |U|).
    void add_drag(std::ptrdiff_t start, std::size_t num_cells, Chunk& chunk)
    {
        for (std::size_t j = 0; j < num_cells; ++j) {
            const std::int32_t slot = drag_of_cell_[static_cast<std::size_t>(start) + j];
            if (slot < 0) continue;
            Drag& drag = drag_[static_cast<std::size_t>(slot)];
            const DragCell& cell = drag.coefficients;
            Vec3 free;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                free[static_cast<int>(axis)] =
                    static_cast<double>(chunk.velocity[axis][j] + 0.5F * chunk.force[axis][j]);
            }
            const double normal_rate = fluid.viscosity_lu * cell.darcy_normal_lu +
                                       0.5 * drag.speed * cell.forchheimer_normal_lu;
            const double tangential_rate = fluid.viscosity_lu * cell.darcy_tangential_lu +
                                           0.5 * drag.speed * cell.forchheimer_tangential_lu;
            const Vec3 along = cell.normal.dot(free) * cell.normal;
            const Vec3 normal_velocity = along / (1.0 + 0.5 * normal_rate);
            const Vec3 tangential_velocity = (free - along) / (1.0 + 0.5 * tangential_rate);
            drag.speed = (normal_velocity + tangential_velocity).norm();
            drag.sink = -normal_rate * normal_velocity - tangential_rate * tangential_velocity;
            for (std::size_t axis = 0; axis < 3; ++axis)
                chunk.force[axis][j] += static_cast<float>(drag.sink[static_cast<int>(axis)]);
        }
    }

    /// Sum of the velocities of a span's cells but for half of their drag: after collision the
    /// momentum is U + F / 2.
    Vec3 velocity_sum(const FluidSpan& span) const
    {
        Vec3 sum = Vec3::Zero();
        for (int i = 1; i < d3q19::num_velocities; i += 2) {
            const float* forth = of(populations_, i) + span.start;
            const float* back = of(populations_, i + 1) + span.start;
            double total = 0.0;
            for (int j = 0; j < span.length; ++j)
                total += static_cast<double>(forth[j] - back[j]);
            const auto& c = d3q19::velocity[static_cast<std::size_t>(i)];
            sum += total * Vec3(c[0], c[1], c[2]);
        }
        if (is_forced(span)) sum -= 0.5 * span.length * body_force;
        return sum;
    }

    PeriodicBox box_;
    std::ptrdiff_t size_;
    std::vector<float> populations_;  ///< after collision; one array with ghosts each
    std::vector<float> next_;
    LatticeWalls walls_;
    std::array<std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>>, d3q19::num_velocities>
        ghosts_;
    std::vector<Drag> drag_;
    std::vector<std::int32_t> drag_of_cell_;  ///< place in `drag_`, or -1; empty without drag
};

}  // namespace braidzone::test

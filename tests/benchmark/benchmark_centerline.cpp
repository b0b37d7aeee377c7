// Cost of a centerline through a siphon of 81,000 triangles with nine openings, whose branches are
// down to a sixth of the artery's radius: between the two largest openings, from the largest to the
// smallest, and between the two smallest.
//
// Figure to reach: 3 s on one core, with the reading of the surface.

#include "benchmark/measuring.hpp"
#include "core/centerline_compute.hpp"
#include "core/phantom.hpp"
#include "core/vessel.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>

namespace braidzone {
namespace {

Phantom siphon_with_branches()
{
    Phantom phantom;
    phantom.proximal_radius = 2.1e-3;
    phantom.distal_radius = 1.6e-3;
    phantom.blend_radius = 0.2e-3;
    phantom.edge_length = 0.159e-3;
    phantom.segments = {{.length = 12e-3}, {.length = 9e-3, .angle = 2.4},
                        {.length = 4e-3},  {.length = 9e-3, .angle = 2.6, .plane_angle = 3.14159},
                        {.length = 5e-3},  {.length = 6e-3, .angle = 1.2, .plane_angle = 1.5},
                        {.length = 10e-3}};
    struct Branch {
        double position, direction, radius;
    };
    constexpr std::array<Branch, 7> branches = {{{4e-3, 1.5, 0.4e-3},
                                                 {8e-3, 4.5, 0.7e-3},
                                                 {23e-3, 1.6, 0.35e-3},
                                                 {36e-3, 1.5, 0.5e-3},
                                                 {47e-3, 0.5, 0.9e-3},
                                                 {50e-3, 2.5, 0.5e-3},
                                                 {52e-3, 4.6, 0.6e-3}}};
    for (const Branch& branch : branches) {
        phantom.branches.push_back({.position = branch.position,
                                    .direction = branch.direction,
                                    .radius = branch.radius,
                                    .length = 7e-3});
    }
    return phantom;
}

const TriangleMesh& surface()
{
    static const TriangleMesh mesh = make_phantom(siphon_with_branches()).wall;
    return mesh;
}

void find_vessel(benchmark::State& state)
{
    const auto limit = thread_limit(state);
    surface();
    for (auto _ : state)
        benchmark::DoNotOptimize(make_vessel(surface(), LengthUnit{"mm", 1e-3}));
}

void find_centerline(benchmark::State& state)
{
    const auto limit = thread_limit(state);
    const Vessel vessel = make_vessel(surface(), LengthUnit{"mm", 1e-3});
    const auto centre = [&](std::int64_t opening) {
        return vessel.openings.at(static_cast<std::size_t>(opening)).centre;
    };
    const Vec3 from = centre(state.range(1)), to = centre(state.range(2));
    for (auto _ : state) {
        const WallTree wall(vessel);
        benchmark::DoNotOptimize(compute_centerline(vessel, wall, from, to));
    }
    state.counters["triangles"] = static_cast<double>(vessel.wall.triangles.size());
    state.counters["openings"] = static_cast<double>(vessel.openings.size());
    report_memory(state);
}

BENCHMARK(find_vessel)->ArgName("threads")->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(find_centerline)
    ->ArgNames({"threads", "from", "to"})
    ->Args({1, 0, 1})
    ->Args({1, 0, 8})
    ->Args({1, 7, 8})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace braidzone

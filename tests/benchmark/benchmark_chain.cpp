// Speed of the deployment and of the whole chain, on one thread and on all, with peak memory.
//
// Figures to reach: a 4x20 device of 48 wires in a vessel of 10,000 triangles in 0.25 s on one
// core; the whole chain at 0.1 mm voxels in 2 s.

#include "benchmark/measuring.hpp"
#include "cli/pipeline.hpp"
#include "cli/result_files.hpp"
#include "core/wall_tree.hpp"
#include "deploy/deployment.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>

namespace braidzone {
namespace {

void deploy_in_case(benchmark::State& state, const std::string& name)
{
    const auto limit = thread_limit(state);
    const Case job = read_case(shipped_case(name));
    Progress progress(true);
    const Chain chain = run_chain(job, Stage::deploy, progress);
    const double landing = chain.deployment.ring_arc_length.front();
    for (auto _ : state) {
        benchmark::DoNotOptimize(deploy(job.device, chain.centerline, chain.wall, landing,
                                        job.schedule, job.deployment));
    }
    state.counters["nodes"] = chain.deployment.lattice.num_nodes();
    state.counters["triangles"] = static_cast<double>(chain.vessel.wall.triangles.size());
    report_memory(state);
}

/// A straight tube of `triangles`, for the cost against the vessel's fineness.
void deploy_in_tube(benchmark::State& state)
{
    const auto limit = thread_limit(state);
    const double radius = 1.85e-3, length = 26e-3;
    // Triangles of the same shape at every fineness: 70 sides for 10,000.
    const double triangles = static_cast<double>(state.range(1));
    const int around = static_cast<int>(std::lround(70.0 * std::sqrt(triangles / 1e4)));
    const int along = static_cast<int>(std::lround(triangles / (2 * around)));
    const Vessel vessel = test::tube_vessel(radius, length, around, along);
    const WallTree wall(vessel);
    const Centerline centerline = test::tube_centerline(radius, length);
    const Case job = read_case(shipped_case("straight_tube"));
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            deploy(job.device, centerline, wall, 23e-3, job.schedule, job.deployment));
    }
    state.counters["triangles"] = static_cast<double>(vessel.wall.triangles.size());
    report_memory(state);
}

/// A straight tube of 10,000 triangles and a device of the given length and number of wires, for
/// the cost against the number of nodes: (wires / 2)^2 times length over t pi R0.
void deploy_device(benchmark::State& state)
{
    const auto limit = thread_limit(state);
    const double radius = 1.85e-3, length = 60e-3;
    const Vessel vessel = test::tube_vessel(radius, length, 70, 71);
    const WallTree wall(vessel);
    const Centerline centerline = test::tube_centerline(radius, length);
    Case job = read_case(shipped_case("straight_tube"));
    job.device.nominal_length = 1e-3 * static_cast<double>(state.range(1));
    job.device.num_wires = static_cast<int>(state.range(2));
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            deploy(job.device, centerline, wall, 57e-3, job.schedule, job.deployment));
    }
    state.counters["nodes"] = make_lattice(job.device).num_nodes();
    report_memory(state);
}

/// From the case file to every result file, at 0.1 mm voxels.
void whole_chain(benchmark::State& state, const std::string& name)
{
    const auto limit = thread_limit(state);
    const test::TemporaryFolder folder;
    for (auto _ : state) {
        const Case job = read_case(shipped_case(name), {"grid.spacing=0.1 mm"});
        Progress progress(true);
        const Chain chain = run_chain(job, Stage::exports, progress);
        const auto output = folder.path() / "out";
        std::filesystem::remove_all(output);
        std::filesystem::create_directory(output);
        write_results(job, chain, Stage::exports, output);
    }
    report_memory(state);
}

BENCHMARK(deploy_in_tube)
    ->ArgNames({"threads", "triangles"})
    ->Args({1, 10000})
    ->Args({0, 10000})
    ->Args({1, 100000})
    ->Args({1, 1000000})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(deploy_device)
    ->ArgNames({"threads", "length_mm", "wires"})
    ->Args({1, 10, 48})
    ->Args({1, 20, 48})
    ->Args({1, 40, 48})
    ->Args({1, 20, 24})
    ->Args({1, 20, 64})
    ->Args({1, 20, 96})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(deploy_in_case, sidewall_aneurysm, "sidewall_aneurysm")
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(whole_chain, sidewall_aneurysm, "sidewall_aneurysm")
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(0)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace braidzone

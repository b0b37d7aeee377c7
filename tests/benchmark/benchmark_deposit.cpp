// Cost of depositing a 4x20 device onto voxels, against OpenVDB's mesh-to-volume on the same
// surfaces. Each measurement runs in the process that prints it; for the peak memory of one, run it
// alone with --benchmark_filter.
//
// Figure to reach: 0.05 mm voxels in 0.5 s on one core.

#include "benchmark/measuring.hpp"
#include "cli/pipeline.hpp"

#include <benchmark/benchmark.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

namespace braidzone {
namespace {

/// The sidewall case up to the sheet.
const Chain& sidewall_chain()
{
    static const Chain chain = [] {
        Progress progress(true);
        return run_chain(read_case(shipped_case("sidewall_aneurysm")), Stage::deploy, progress);
    }();
    return chain;
}

double spacing_of(const benchmark::State& state)
{
    return 1e-6 * static_cast<double>(state.range(1));
}

void deposit_device(benchmark::State& state)
{
    const auto limit = thread_limit(state);
    const Chain& chain = sidewall_chain();
    double touched = 0.0, held = 0.0, box = 0.0;
    for (auto _ : state) {
        const PorousField field =
            deposit(chain.resistance, chain.vessel, {.spacing = spacing_of(state)});
        touched = static_cast<double>(field.voxels.size());
        held = static_cast<double>(field.wall_distance.of_voxels.size());
        box = static_cast<double>(field.grid.num_voxels());
    }
    state.counters["touched"] = touched;
    state.counters["held"] = held;
    state.counters["box"] = box;
    report_memory(state);
}

openvdb::Vec3s in_index_space(const Vec3& point, double spacing)
{
    const Vec3 scaled = point / spacing;
    return {static_cast<float>(scaled.x()), static_cast<float>(scaled.y()),
            static_cast<float>(scaled.z())};
}

/// Distances of voxels to the device's surface within the kernel's reach, and signed ones to the
/// vessel's within three voxels: what OpenVDB makes of the two surfaces, without any resistance.
void mesh_to_volume(benchmark::State& state)
{
    const auto limit = thread_limit(state);
    openvdb::initialize();
    const Chain& chain = sidewall_chain();
    const double spacing = spacing_of(state);
    const auto transform = openvdb::math::Transform::createLinearTransform(1.0);
    std::vector<openvdb::Vec3s> device_points, wall_points;
    std::vector<openvdb::Vec4I> rhombi;
    std::vector<openvdb::Vec3I> triangles;
    for (const Vec3& point : chain.resistance.surface.points)
        device_points.push_back(in_index_space(point, spacing));
    for (const auto& corners : chain.resistance.surface.corners)
        rhombi.emplace_back(corners.data());
    for (const Vec3& point : chain.vessel.wall.points)
        wall_points.push_back(in_index_space(point, spacing));
    for (const auto& corners : chain.vessel.wall.triangles)
        triangles.emplace_back(corners.data());
    constexpr float kernel_reach = 2.0F;
    for (auto _ : state) {
        benchmark::DoNotOptimize(openvdb::tools::meshToUnsignedDistanceField<openvdb::FloatGrid>(
            *transform, device_points, {}, rhombi, kernel_reach));
        benchmark::DoNotOptimize(
            openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, wall_points, triangles));
    }
    report_memory(state);
}

void on_voxels(benchmark::internal::Benchmark* measured)
{
    measured->ArgNames({"threads", "spacing_um"})
        ->Args({1, 100})
        ->Args({1, 50})
        ->Args({1, 25})
        ->Args({0, 50})
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

BENCHMARK(deposit_device)->Apply(on_voxels);
BENCHMARK(mesh_to_volume)->Apply(on_voxels);

}  // namespace
}  // namespace braidzone

#pragma once

#include <benchmark/benchmark.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <sys/resource.h>

#include <filesystem>
#include <string>

namespace braidzone {

inline std::filesystem::path shipped_case(const std::string& name)
{
    return std::filesystem::path(BRAIDZONE_SOURCE_DIR) / "cases" / name / "case.toml";
}

/// Limits the threads to the benchmark's first argument; 0 means all.
inline tbb::global_control thread_limit(const benchmark::State& state)
{
    const auto all = static_cast<std::size_t>(tbb::info::default_concurrency());
    const auto asked = static_cast<std::size_t>(state.range(0));
    return tbb::global_control(tbb::global_control::max_allowed_parallelism,
                               asked == 0 ? all : asked);
}

/// Largest resident set of the process so far [MB]: the highest of this and earlier benchmarks.
inline void report_memory(benchmark::State& state)
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace braidzone

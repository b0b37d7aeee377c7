#include "cli/diagnosed_case.hpp"

#include "cli/case_geometry.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace braidzone {
namespace {

/// What the effects' fits cannot vary, or not within minutes.
void require_covered(const Case& job)
{
    if (job.second_device) {
        throw ConfigError(fmt::format("{}: second_device is not covered by diagnose; leave it out",
                                      job.file.string()));
    }
    if (job.deployment.axial == AxialMotion::free) {
        throw ConfigError(fmt::format(
            "{}: deployment.axial = \"free\" is not covered by diagnose, which deploys the device "
            "hundreds of times; set it to \"locked\"",
            job.file.string()));
    }
}

}  // namespace

Case read_diagnosed_case(const std::filesystem::path& file,
                         const std::vector<std::string>& overrides)
{
    Case job = read_case(file, overrides);
    require_covered(job);
    const auto absolute = [](const std::filesystem::path& path) {
        return std::filesystem::absolute(path).lexically_normal();
    };
    job.vessel.surface = absolute(job.vessel.surface);
    if (job.vessel.centerline) job.vessel.centerline = absolute(*job.vessel.centerline);
    return job;
}

Lumen lumen_of(const Case& job)
{
    VesselSource source = job.vessel;
    source.wall_offset = 0.0;
    Vessel vessel = read_vessel(source);
    WallTree wall(vessel);
    Centerline centerline = resample(find_centerline(source, vessel, wall).line);
    return {std::move(vessel), std::move(wall), std::move(centerline)};
}

}  // namespace braidzone

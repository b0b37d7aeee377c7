#include "cli/commands.hpp"
#include "cli/output_files.hpp"
#include "core/centerline_io.hpp"
#include "core/phantom.hpp"
#include "core/phantom_file.hpp"
#include "core/surface_io.hpp"

#include <fmt/format.h>

namespace braidzone {

void write_phantom(const std::filesystem::path& parameters, const CommonOptions& options)
{
    const Phantom phantom = read_phantom(TomlTable::read_file(parameters, options.overrides));
    const auto folder =
        options.output.value_or(std::filesystem::absolute(parameters).parent_path());
    OutputFiles files({{"phantom file", parameters}}, options.force);
    const auto surface = files.add(folder / "vessel.stl");
    const auto line = files.add(folder / "centerline.vtp");

    Progress progress(options.quiet);
    progress.begin("phantom", "making the vessel");
    const PhantomVessel vessel = make_phantom(phantom);
    progress.end();
    const LengthUnit unit = length_unit("mm");
    write_stl(surface, vessel.wall, unit);
    write_centerline(line, vessel.centerline, unit);
    files.commit();

    if (options.quiet) return;
    fmt::print("{} triangles: {}\ncenterline: {}\n", vessel.wall.triangles.size(),
               (folder / "vessel.stl").string(), (folder / "centerline.vtp").string());
}

}  // namespace braidzone

#pragma once

#include "core/error.hpp"
#include "export/vdb_mark.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace braidzone {

/// Writes grids to an OpenVDB file; equal grids give equal files (`vdb_mark.hpp`).
/// @tparam File     openvdb::io::File, and
/// @tparam Failure  openvdb::Exception, given by the caller so that this header needs no OpenVDB
/// @param grids     what `File::write` takes
/// @throws IoError if the file cannot be written
template <typename File, typename Failure, typename Grids>
void write_vdb_file(const std::filesystem::path& path, const Grids& grids)
{
    try {
        File file(path.string());
        file.write(grids);
        file.close();
    } catch (const Failure& error) {
        throw IoError(fmt::format("{}: {}", path.string(), error.what()));
    }
    replace_vdb_mark(path);
}

}  // namespace braidzone

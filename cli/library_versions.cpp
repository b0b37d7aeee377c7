#include "cli/library_versions.hpp"

#include <CGAL/version.h>
#include <Eigen/Core>
#include <fmt/format.h>
#include <oneapi/tbb/version.h>
#include <openvdb/version.h>
#include <vtkVersionMacros.h>

namespace braidzone {

std::map<std::string, std::string> library_versions()
{
    return {{"braidzone", BRAIDZONE_VERSION},
            {"compiler", __VERSION__},
            {"cgal", CGAL_VERSION_STR},
            {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                  EIGEN_MINOR_VERSION)},
            {"openvdb", OPENVDB_LIBRARY_VERSION_STRING},
            {"tbb", TBB_runtime_version()},
            {"vtk", VTK_VERSION}};
}

}  // namespace braidzone

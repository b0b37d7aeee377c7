// Cell centres and volumes of a mesh by snappyHexMesh, against OpenFOAM's own.

#include "core/phantom.hpp"
#include "core/vessel.hpp"
#include "export/foam_case.hpp"
#include "export/foam_mesh.hpp"
#include "export/text_file.hpp"
#include "external/openfoam.hpp"
#include "support/braids.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace braidzone {
namespace {

void expect_openfoams_geometry(const std::filesystem::path& folder, double tolerance)
{
    ASSERT_TRUE(test::run_in(folder, "postProcess -func writeCellCentres", "log.centres"));
    ASSERT_TRUE(test::run_in(folder, "postProcess -func writeCellVolumes", "log.volumes"));
    const FoamMesh mesh = read_foam_mesh(folder);
    const auto centres =
        test::internal_field(folder / "0/C", [](FoamReader& reader) { return reader.vectors(); });
    const auto volumes =
        test::internal_field(folder / "0/V", [](FoamReader& reader) { return reader.scalars(); });
    ASSERT_EQ(centres.size(), mesh.cell_centres.size());
    ASSERT_EQ(volumes.size(), mesh.cell_volumes.size());
    double worst_centre = 0.0, worst_volume = 0.0;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const double size = std::cbrt(mesh.cell_volumes[i]);
        worst_centre = std::max(worst_centre, (centres[i] - mesh.cell_centres[i]).norm() / size);
        worst_volume = std::max(worst_volume, std::abs(volumes[i] / mesh.cell_volumes[i] - 1.0));
    }
    EXPECT_LT(worst_centre, tolerance);
    EXPECT_LT(worst_volume, tolerance);
    std::printf("%d cells, centres within %.2g of their size, volumes within %.2g\n",
                mesh.num_cells(), worst_centre, worst_volume);
}

/// A coarse case of a short tube with a small sac, without device.
void write_small_case(const std::filesystem::path& folder)
{
    Phantom phantom;
    phantom.segments = {{.length = 10e-3}};
    PhantomSac sac;
    sac.position = 5e-3;
    sac.diameter = sac.height = 4e-3;
    sac.neck = 3e-3;
    phantom.sacs = {sac};
    const Vessel vessel = make_vessel(make_phantom(phantom).wall, {"mm", 1e-3});
    FoamCaseOptions options;
    options.coarse_cell = 0.6e-3;
    write_foam_case(folder, vessel, ResistanceSheet{}, Fluid{}, options);
}

TEST(OpenFoamMesh, CentresAndVolumesAreOpenFoams)
{
    if (!test::has_openfoam()) GTEST_SKIP() << "simpleFoam is not installed";
    const test::TemporaryFolder temporary;
    const auto& folder = temporary.path();
    write_small_case(folder);
    ASSERT_TRUE(test::run_in(
        folder, "blockMesh && surfaceFeatureExtract && snappyHexMesh -overwrite", "log.mesh"));
    // Binary files hold every digit. A volume is a sum of terms up to 100 times as large as itself.
    expect_openfoams_geometry(folder, 1e-12);

    // Gzipped ASCII with 12 digits. Coordinates are up to 50 cells from the origin, and a volume is
    // a difference of products of them.
    const std::string control = test::file_text(folder / "system/controlDict");
    std::string ascii = control;
    ascii.replace(ascii.find("binary"), 6, "ascii");
    ascii.replace(ascii.find("writeCompression off"), 20, "writeCompression on");
    write_text_file(folder / "system/controlDict", ascii);
    ASSERT_TRUE(test::run_in(folder, "foamFormatConvert -constant", "log.convert"));
    ASSERT_TRUE(std::filesystem::exists(folder / "constant/polyMesh/points.gz"));
    expect_openfoams_geometry(folder, 1e-8);
}

}  // namespace
}  // namespace braidzone

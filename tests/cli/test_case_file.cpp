#include "cli/case_file.hpp"
#include "cli/resolved_case.hpp"
#include "core/error.hpp"
#include "support/case_texts.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace braidzone {
namespace {

constexpr auto everything = R"([vessel]
surface = "/data/vessel.vtp"
length_unit = "cm"
repair = true
centerline = "lines/centerline.vtp"
centerline_line = 2
reverse_centerline = true
[device]
name = "pipeline-flex"
diameter = "4.25 mm"
length = "20 mm"
wire_diameter = "28 um"
[deployment]
landing_distal = ["1 mm", "2 mm", "3.3 mm"]
time_step_ratio = 0.7
damping = "0.05 kg/s"
centre_rings = false
bending_ratio = 0.4
release_interval = 30
residual_tolerance = 1e-5
max_settling_steps = 1234
lattice = "paper-2020"
release_order = "at_once"
motion = "quasi_static"
ring_hub = "free"
hoop_migration = true
friction = 0.15
wall_stiffness = "1e8 Pa/m"
num_frames = 7
neck = { from = "9 mm", to = "13 mm" }
[second_device]
name = "pipeline-flex"
diameter = "4 mm"
length = "16 mm"
landing_distal = "17 mm"
[[second_device.push_pull]]
from = "9 mm"
to = "11 mm"
spacing = 0.8
[[deployment.push_pull]]
from = "8 mm"
to = "14 mm"
spacing = 0.34
[fluid]
density = "1060 kg/m^3"
viscosity = "4 mPa s"
[porous]
law = "constant"
pressure_loss_linear = "490 Pa s/m"
pressure_loss_quadratic = "330 kg/m^3"
tangential_ratio = 1.5
quadratic = "normal"
region = "whole"
[grid]
spacing = "0.15 mm"
kernel_half_width = 3
[[export]]
format = "openfoam"
inlet_velocity = "30 cm/s"
coarse_cell = "0.4 mm"
surface_refinement = 2
device_refinement = 3
[[export]]
format = "lattice"
targets = ["openlb", "numpy"]
peak_velocity = "40 cm/s"
velocity_lu = 0.04
openings = "extended_z"
[[export]]
format = "surfaces"
parts = ["wires", "distance"]
braid_pattern = "1-over-1"
wire_facets = 12
wire_pieces = 8
shell_thickness = "0.1 mm"
distance_spacing = "0.05 mm"
)";

TEST(CaseFile, NeedsFewKeys)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(folder.write("case.toml", test::smallest_case));
    EXPECT_EQ(job.vessel.surface, folder.path() / "vessel.stl");
    EXPECT_EQ(job.vessel.unit.metres, 1e-3);
    EXPECT_FALSE(job.vessel.centerline.has_value());
    EXPECT_FALSE(job.vessel.from.has_value());
    EXPECT_EQ(job.device.nominal_diameter, 4e-3);
    EXPECT_EQ(std::get<double>(job.landing_distal), 18e-3);
    EXPECT_EQ(job.fluid.density, 1056.0);
    EXPECT_EQ(law_name(job.law), "braid-stokes");
    EXPECT_EQ(job.sheet.tangential_ratio, 1.0);
    EXPECT_EQ(job.sheet.quadratic, QuadraticDrag::whole_velocity);
    EXPECT_EQ(job.deposit.spacing, 1e-4);
    EXPECT_TRUE(job.deployment.centre_rings);
    EXPECT_TRUE(job.exports.openfoam.has_value());
}

TEST(CaseFile, GivesEveryValueInSi)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(folder.write("case.toml", everything));
    EXPECT_EQ(job.vessel.surface, "/data/vessel.vtp");
    EXPECT_EQ(job.vessel.unit.metres, 1e-2);
    EXPECT_EQ(job.vessel.repair, all_repairs);
    EXPECT_EQ(job.vessel.centerline, folder.path() / "lines" / "centerline.vtp");
    EXPECT_EQ(job.vessel.centerline_line, 2);
    EXPECT_TRUE(job.vessel.reverse_centerline);
    EXPECT_EQ(job.device.wire_diameter, 28e-6);
    EXPECT_DOUBLE_EQ(std::get<Vec3>(job.landing_distal).z(), 3.3e-3);
    EXPECT_EQ(job.deployment.time_step_ratio, 0.7);
    EXPECT_EQ(job.deployment.damping, 0.05);
    EXPECT_FALSE(job.deployment.centre_rings);
    EXPECT_EQ(job.deployment.bending_ratio, 0.4);
    EXPECT_EQ(job.deployment.release_interval, 30);
    EXPECT_EQ(job.deployment.residual_tolerance, 1e-5);
    EXPECT_EQ(job.deployment.max_settling_steps, 1234);
    ASSERT_EQ(job.schedule.windows.size(), 1u);
    EXPECT_EQ(job.schedule.windows[0].to, 14e-3);
    EXPECT_EQ(job.schedule.windows[0].spacing, 0.34);
    EXPECT_EQ(job.fluid.density, 1060.0);
    EXPECT_EQ(job.fluid.viscosity, 4e-3);
    EXPECT_EQ(std::get<ConstantLaw>(job.law).loss.linear, 490.0);
    EXPECT_EQ(std::get<ConstantLaw>(job.law).loss.quadratic, 330.0);
    EXPECT_EQ(job.sheet.tangential_ratio, 1.5);
    EXPECT_EQ(job.sheet.quadratic, QuadraticDrag::normal_only);
    EXPECT_EQ(job.sheet.region, ResistanceRegion::whole_device);
    EXPECT_DOUBLE_EQ(job.deposit.spacing, 0.15e-3);
    EXPECT_EQ(job.deposit.kernel_half_width, 3);
    ASSERT_TRUE(job.exports.openfoam.has_value());
    EXPECT_EQ(job.exports.openfoam->flow.inlet_velocity, 0.3);
    EXPECT_DOUBLE_EQ(job.exports.openfoam->coarse_cell, 0.4e-3);
    EXPECT_EQ(job.exports.openfoam->surface_refinement, 2);
    EXPECT_EQ(job.exports.openfoam->device_refinement, 3);
    ASSERT_TRUE(job.exports.lattice.has_value());
    EXPECT_EQ(job.exports.lattice->targets,
              (std::vector{LatticeTarget::openlb, LatticeTarget::numpy}));
    EXPECT_DOUBLE_EQ(job.exports.lattice->flow.peak_velocity, 0.4);
    EXPECT_EQ(job.exports.lattice->flow.velocity_lu, 0.04);
    EXPECT_EQ(job.exports.lattice->openings, OpeningFaces::extended_z);
    ASSERT_TRUE(job.exports.surfaces.has_value());
    EXPECT_EQ(job.exports.surfaces->parts,
              (std::vector{SurfacePart::wires, SurfacePart::distance}));
    EXPECT_EQ(job.exports.surfaces->wires.pattern.over, 1);
    EXPECT_EQ(job.exports.surfaces->wires.facets, 12);
    EXPECT_EQ(job.exports.surfaces->wires.pieces_per_arm, 8);
    EXPECT_DOUBLE_EQ(job.exports.surfaces->shell_thickness, 0.1e-3);
    EXPECT_DOUBLE_EQ(job.exports.surfaces->distance_spacing, 0.05e-3);
}

TEST(CaseFile, WritesSurfacesAtTheFieldsSpacingByDefault)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(folder.write(
        "case.toml", std::string(test::smallest_case) +
                         "[grid]\nspacing = \"0.15 mm\"\n[[export]]\nformat = \"surfaces\"\n"));
    EXPECT_FALSE(job.exports.openfoam.has_value());
    ASSERT_TRUE(job.exports.surfaces.has_value());
    EXPECT_EQ(job.exports.surfaces->parts.size(), 4U);
    EXPECT_EQ(job.exports.surfaces->wires.pattern.over, 2);
    EXPECT_DOUBLE_EQ(job.exports.surfaces->distance_spacing, 0.15e-3);
}

TEST(CaseFile, ReadsANeckAndASecondDevice)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(folder.write("case.toml", everything));
    ASSERT_TRUE(job.neck.has_value());
    EXPECT_DOUBLE_EQ(job.neck->from, 9e-3);
    EXPECT_DOUBLE_EQ(job.neck->to, 13e-3);
    ASSERT_TRUE(job.second_device.has_value());
    EXPECT_DOUBLE_EQ(job.second_device->device.nominal_length, 16e-3);
    EXPECT_DOUBLE_EQ(std::get<double>(job.second_device->landing_distal), 17e-3);
    ASSERT_EQ(job.second_device->schedule.windows.size(), 1U);
    EXPECT_DOUBLE_EQ(job.second_device->schedule.windows[0].spacing, 0.8);
}

TEST(CaseFile, TakesEndsOfAComputedCenterline)
{
    const test::TemporaryFolder folder;
    std::string text = test::smallest_case;
    text.insert(text.find("[device]"), "from = 1\nto = [\"1 mm\", \"2 mm\", \"3 mm\"]\n");
    const Case job = read_case(folder.write("case.toml", text));
    EXPECT_EQ(std::get<int>(*job.vessel.from), 1);
    EXPECT_EQ(std::get<Vec3>(*job.vessel.to), Vec3(1e-3, 2e-3, 3e-3));
}

TEST(CaseFile, LetsOverridesWin)
{
    const test::TemporaryFolder folder;
    const Case job = read_case(folder.write("case.toml", test::smallest_case),
                               {"device.diameter=4.5 mm", "grid.spacing=0.2 mm"});
    EXPECT_EQ(job.device.nominal_diameter, 4.5e-3);
    EXPECT_EQ(job.deposit.spacing, 2e-4);
}

TEST(CaseFile, TakesEveryLawByName)
{
    const test::TemporaryFolder folder;
    folder.write("loss.csv",
                 "metal_coverage,wire_spacing_um,velocity_mm_s,pressure_drop_Pa\n"
                 "0.3,190,10,1.5\n0.3,190,50,7.9\n");
    const std::map<std::string, std::string> keys{
        {"measured",
         "loss_table = \"loss.csv\"\nbench_density = \"998 kg/m^3\"\n"
         "bench_viscosity = \"1 mPa s\"\n"},
        {"constant", "pressure_loss_linear = \"490 Pa s/m\"\n"},
        {"brundrett", "fit_velocity = \"50 mm/s\"\n"}};
    for (const std::string& name : law_names()) {
        const auto more = keys.find(name);
        const std::string text = std::string(test::smallest_case) + "[porous]\nlaw = \"" + name +
                                 "\"\n" + (more == keys.end() ? "" : more->second);
        const Case job = read_case(folder.write("case.toml", text));
        EXPECT_EQ(law_name(job.law), name);
        const Case again = read_case(folder.write("again.toml", resolved_case_text(job)));
        EXPECT_EQ(resolved_case(again).dump(2), resolved_case(job).dump(2)) << name;
        if (const auto* brundrett = std::get_if<BrundrettLaw>(&job.law)) {
            EXPECT_EQ(brundrett->fit_velocity, 0.05);
        }
        if (const auto* measured = std::get_if<MeasuredLaw>(&job.law)) {
            EXPECT_EQ(measured->braids.size(), 1U);
        }
    }
}

TEST(ResolvedCase, ReadsBackAsTheSameCase)
{
    const test::TemporaryFolder folder;
    std::string computed = test::smallest_case;
    computed.insert(computed.find("[device]"), "from = 1\nto = [\"1 mm\", \"2 mm\", \"3 mm\"]\n");
    for (const std::string& text :
         {std::string(test::smallest_case), std::string(everything), computed}) {
        const Case job = read_case(folder.write("case.toml", text));
        const Case again = read_case(folder.write("again.toml", resolved_case_text(job)));
        EXPECT_EQ(resolved_case(again).dump(2), resolved_case(job).dump(2));
        EXPECT_EQ(again.device.reference_node_area, job.device.reference_node_area);
        EXPECT_EQ(again.device.braid_ratio, job.device.braid_ratio);
        EXPECT_EQ(again.vessel.surface, job.vessel.surface);
    }
}

TEST(ResolvedCase, StatesDefaultsAndUnits)
{
    const test::TemporaryFolder folder;
    const auto json = resolved_case(read_case(folder.write("case.toml", test::smallest_case)));
    EXPECT_EQ(json["vessel"]["surface"], (folder.path() / "vessel.stl").string());
    EXPECT_EQ(json["vessel"]["length_unit"], "mm");
    EXPECT_EQ(json["device"]["wire_diameter"], "3e-05 m");
    EXPECT_EQ(json["fluid"]["viscosity"], "0.0035 Pa s");
    EXPECT_EQ(json["porous"]["region"], "free");
    EXPECT_EQ(json["export"].size(), 3u);
}

}  // namespace
}  // namespace braidzone

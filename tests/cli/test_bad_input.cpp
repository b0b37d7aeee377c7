#include "support/program.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

/// A copy of the shipped straight tube (3.7 mm wide, PED 4x20) that a test spoils.
class Workplace {
public:
    Workplace()
    {
        const fs::path shipped = fs::path(BRAIDZONE_SOURCE_DIR) / "cases" / "straight_tube";
        for (const char* file : {"vessel.stl", "centerline.vtp"}) {
            fs::copy_file(shipped / file, folder_.path() / file);
        }
        folder_.write("case.toml", case_text_);
    }

    const fs::path& path() const { return folder_.path(); }
    fs::path output() const { return path() / "case.out"; }

    void write(const std::string& name, const std::string& text) const
    {
        folder_.write(name, text);
    }

    /// Replaces a piece of the case file.
    void replace(const std::string& old_text, const std::string& new_text)
    {
        const auto at = case_text_.find(old_text);
        ASSERT_NE(at, std::string::npos) << old_text;
        case_text_.replace(at, old_text.size(), new_text);
        folder_.write("case.toml", case_text_);
    }

    void append(const std::string& text)
    {
        case_text_ += text;
        folder_.write("case.toml", case_text_);
    }

    /// Replaces the vessel by an ASCII STL.
    void use_mesh(const TriangleMesh& mesh, double units_per_metre = 1e3) const
    {
        std::string text = "solid vessel\n";
        for (const auto& triangle : mesh.triangles) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int corner : triangle) {
                const Vec3 point = units_per_metre * mesh.points[static_cast<std::size_t>(corner)];
                text +=
                    fmt::format("vertex {:.9g} {:.9g} {:.9g}\n", point.x(), point.y(), point.z());
            }
            text += "endloop\nendfacet\n";
        }
        write("vessel.stl", text + "endsolid vessel\n");
    }

    void truncate(const std::string& name, double fraction) const
    {
        const auto size = static_cast<double>(fs::file_size(path() / name));
        fs::resize_file(path() / name, static_cast<std::uintmax_t>(fraction * size));
    }

private:
    test::TemporaryFolder folder_;
    std::string case_text_ = R"([vessel]
surface = "vessel.stl"
length_unit = "mm"
centerline = "centerline.vtp"
[device]
name = "pipeline-flex"
diameter = "4 mm"
length = "20 mm"
[deployment]
landing_distal = "23 mm"
[fluid]
density = "1056 kg/m^3"
viscosity = "3.5 mPa s"
[porous]
law = "braid-stokes"
tangential_ratio = 1.0
[grid]
spacing = "0.2 mm"
[[export]]
format = "vtk"
)";
};

TriangleMesh straight_tube()
{
    return test::tube(1.85e-3, 26e-3, 48, 60);
}

/// A sphere: closed, and flat nowhere.
TriangleMesh sphere(double radius)
{
    const int around = 40, along = 20;
    TriangleMesh mesh;
    for (int k = 1; k < along; ++k) {
        const double polar = std::numbers::pi * k / along;
        for (int j = 0; j < around; ++j) {
            const double angle = 2.0 * std::numbers::pi * j / around;
            mesh.points.emplace_back(radius * std::sin(polar) * std::cos(angle),
                                     radius * std::sin(polar) * std::sin(angle),
                                     radius * (1.0 - std::cos(polar)));
        }
    }
    const int bottom = static_cast<int>(mesh.points.size()), top = bottom + 1;
    mesh.points.emplace_back(0, 0, 0);
    mesh.points.emplace_back(0, 0, 2.0 * radius);
    for (int j = 0; j < around; ++j) {
        const int next = (j + 1) % around, last = (along - 2) * around;
        mesh.triangles.push_back({bottom, next, j});
        mesh.triangles.push_back({top, last + j, last + next});
        for (int k = 0; k + 2 < along; ++k) {
            const int a = k * around + j, b = k * around + next;
            mesh.triangles.push_back({a, b, b + around});
            mesh.triangles.push_back({a, b + around, a + around});
        }
    }
    return mesh;
}

struct BadInput {
    std::string name;
    std::function<void(Workplace&)> spoil;
    int status;
    std::vector<std::string> pieces;          ///< of the message
    std::vector<std::string> arguments = {};  ///< after `run case.toml`
};

void PrintTo(const BadInput& bad, std::ostream* out)
{
    *out << bad.name;
}

/// Changes one piece of the case file.
std::function<void(Workplace&)> change(const std::string& old_text, const std::string& new_text)
{
    return [=](Workplace& work) { work.replace(old_text, new_text); };
}

std::function<void(Workplace&)> add(const std::string& text)
{
    return [=](Workplace& work) { work.append(text); };
}

void nothing(Workplace&) {}

const std::vector<BadInput> bad_inputs = {
    // Keys of the wrong type.
    {"surface_is_a_number",
     change("\"vessel.stl\"", "4"),
     2,
     {"case.toml:2: vessel.surface = 4 is an integer", "a string"}},
    {"length_unit_is_a_number",
     change("length_unit = \"mm\"", "length_unit = 1"),
     2,
     {"case.toml:3: vessel.length_unit = 1", "a string"}},
    {"centerline_is_a_boolean",
     change("\"centerline.vtp\"", "true"),
     2,
     {"case.toml:4: vessel.centerline = true is a boolean"}},
    {"repair_is_a_string",
     change("length_unit", "repair = \"yes\"\nlength_unit"),
     2,
     {"case.toml:3: vessel.repair = \"yes\" is a string", "true or false"}},
    {"device_name_is_a_number",
     change("\"pipeline-flex\"", "3"),
     2,
     {"case.toml:6: device.name = 3 is an integer", "a string"}},
    {"diameter_is_a_number",
     change("\"4 mm\"", "4"),
     2,
     {"case.toml:7: device.diameter = 4 is an integer", "unit of length: m, cm, mm, um"}},
    {"length_is_a_number",
     change("\"20 mm\"", "20.0"),
     2,
     {"case.toml:8: device.length = 20 is a number", "unit of length"}},
    {"landing_is_a_number",
     change("\"23 mm\"", "23"),
     2,
     {"case.toml:10: deployment.landing_distal = 23 is an integer", "unit of length"}},
    {"landing_has_two_coordinates",
     change("\"23 mm\"", "[\"1 mm\", \"2 mm\"]"),
     2,
     {"case.toml:10: deployment.landing_distal is an array", "x mm"}},
    {"density_is_a_number",
     change("\"1056 kg/m^3\"", "1056"),
     2,
     {"case.toml:12: fluid.density = 1056", "kg/m^3"}},
    {"viscosity_is_a_boolean",
     change("\"3.5 mPa s\"", "false"),
     2,
     {"case.toml:13: fluid.viscosity = false is a boolean", "mPa s"}},
    {"law_is_a_number",
     change("\"braid-stokes\"", "1"),
     2,
     {"case.toml:15: porous.law = 1 is an integer"}},
    {"tangential_ratio_is_a_string",
     change("= 1.0", "= \"1\""),
     2,
     {"case.toml:16: porous.tangential_ratio = \"1\" is a string", "a number"}},
    {"spacing_is_a_number",
     change("\"0.2 mm\"", "0.2"),
     2,
     {"case.toml:18: grid.spacing = 0.2 is a number", "unit of length"}},
    {"export_format_is_a_number",
     change("\"vtk\"", "1"),
     2,
     {"case.toml:20: export.format = 1 is an integer"}},
    {"export_is_a_table",
     change("[[export]]", "[export]"),
     2,
     {"case.toml:19: export is a table", "[[export]]"}},
    {"vessel_is_a_string",
     change("[vessel]\n", "vessel = \"x\"\n[other]\n"),
     2,
     {"case.toml:1: vessel = \"x\" is a string"}},
    {"num_wires_is_a_number",
     add("[dummy]\n"),
     2,
     {"--set device.num_wires = 47.5 is a number"},
     {"--set", "device.num_wires=47.5"}},
    {"release_interval_is_a_string",
     nothing,
     2,
     {"--set deployment.release_interval = \"soon\" is a string", "an integer"},
     {"--set", "deployment.release_interval=soon"}},

    // Units missing or wrong.
    {"unit_missing",
     change("\"4 mm\"", "\"4\""),
     2,
     {"case.toml:7: device.diameter = \"4\" has no unit", "m, cm, mm, um"}},
    {"unit_of_another_dimension",
     change("\"4 mm\"", "\"4 mPa s\""),
     2,
     {"case.toml:7: device.diameter = \"4 mPa s\" has the unit \"mPa s\""}},
    {"unit_unknown",
     change("\"3.5 mPa s\"", "\"3.5 poise\""),
     2,
     {"case.toml:13: fluid.viscosity = \"3.5 poise\" has the unit \"poise\"", "Pa s, mPa s, cP"}},
    {"length_unit_unknown",
     change("length_unit = \"mm\"", "length_unit = \"inch\""),
     2,
     {"case.toml:3: vessel.length_unit = \"inch\"", "m, cm, mm, um"}},
    {"value_is_nan",
     change("\"4 mm\"", "\"nan mm\""),
     2,
     {"case.toml:7: device.diameter = \"nan mm\" is not a finite number"}},
    {"ratio_is_nan",
     change("= 1.0", "= nan"),
     2,
     {"case.toml:16: porous.tangential_ratio", "finite"}},

    // Values out of range.
    {"spacing_is_zero",
     change("\"0.2 mm\"", "\"0 mm\""),
     2,
     {"case.toml:18: grid.spacing = 0 m", "positive"}},
    {"density_is_negative",
     change("\"1056", "\"-1056"),
     2,
     {"case.toml:12: fluid.density = -1056 kg/m^3", "positive"}},
    {"tangential_ratio_is_negative",
     change("= 1.0", "= -1.0"),
     2,
     {"case.toml:16: porous.tangential_ratio = -1 is negative"}},
    {"time_step_beyond_stability",
     nothing,
     2,
     {"--set deployment.time_step_ratio = 1.5 is out of range", "1 at most"},
     {"--set", "deployment.time_step_ratio=1.5"}},
    {"wire_thicker_than_a_tenth",
     nothing,
     2,
     {"--set device.wire_diameter = 1200 um exceeds device.diameter / 10 = 400 um"},
     {"--set", "device.wire_diameter=1.2 mm"}},
    {"odd_number_of_wires",
     nothing,
     2,
     {"--set device.num_wires = 47 is not an even number"},
     {"--set", "device.num_wires=47"}},
    {"push_pull_reversed",
     add("[[deployment.push_pull]]\nfrom = \"14 mm\"\nto = \"8 mm\"\nspacing = 0.34\n"),
     2,
     {"case.toml:", "deployment.push_pull"}},
    {"voxels_too_fine",
     change("\"0.2 mm\"", "\"0.1 um\""),
     2,
     {"case.toml:18: grid.spacing = \"0.1 um\" is out of range; allowed are 0.005 mm to 20 mm"}},

    // Keys and names.
    {"unknown_key",
     change("diameter =", "diametre ="),
     2,
     {"case.toml:5: device.diameter is missing"}},
    {"unknown_extra_key",
     change("[deployment]", "weight = 3\n[deployment]"),
     2,
     {"case.toml:9: device.weight: unknown key"}},
    {"misspelt_optional_key",
     change("tangential_ratio", "tangential_ration"),
     2,
     {"case.toml:16: porous.tangential_ration: unknown key; did you mean \"tangential_ratio\"?"}},
    {"unknown_section",
     change("[fluid]", "[fluids]"),
     2,
     {"case.toml:11: fluids: unknown key; did you mean \"fluid\"?"}},
    {"missing_section", change("[device]\n", ""), 2, {"case.toml: device is missing"}},
    {"unknown_device",
     change("\"pipeline-flex\"", "\"pipline-flex\""),
     2,
     {"case.toml:6: device.name = \"pipline-flex\"", "did you mean \"pipeline-flex\"?"}},
    {"incomplete_device",
     change("\"pipeline-flex\"", "\"p64\""),
     2,
     {"p64 is incomplete", "braid_ratio", "youngs_modulus"}},
    {"size_not_made",
     change("\"4 mm\"", "\"4.1 mm\""),
     2,
     {"case.toml:7: device.diameter = 4.1 mm", "made are 2.5, 2.75, 3", "any_size = true"}},
    {"unknown_law",
     change("\"braid-stokes\"", "\"braid-stoke\""),
     2,
     {"case.toml:15: porous.law = \"braid-stoke\" is not known; did you mean \"braid-stokes\"?"}},
    {"law_without_its_constants",
     change("\"braid-stokes\"", "\"constant\""),
     2,
     {"case.toml:14: porous.pressure_loss_linear is missing", "Pa s/m"}},
    {"measured_law_without_its_table",
     change("\"braid-stokes\"", "\"measured\""),
     2,
     {"case.toml:14: porous.loss_table is missing"}},
    {"loss_table_is_absent",
     change("law = \"braid-stokes\"",
            "law = \"measured\"\nloss_table = \"absent.csv\"\n"
            "bench_density = \"998 kg/m^3\"\nbench_viscosity = \"1 mPa s\""),
     5,
     {"absent.csv cannot be read"}},
    {"loss_table_is_no_table",
     change("law = \"braid-stokes\"",
            "law = \"measured\"\nloss_table = \"case.toml\"\n"
            "bench_density = \"998 kg/m^3\"\nbench_viscosity = \"1 mPa s\""),
     3,
     {"case.toml:1: ", "is not the header of a table of pressure drops", "metal_coverage"}},
    {"bench_viscosity_without_unit",
     change("law = \"braid-stokes\"",
            "law = \"measured\"\nloss_table = \"loss.csv\"\n"
            "bench_density = \"998 kg/m^3\"\nbench_viscosity = 1e-3"),
     2,
     {"porous.bench_viscosity", "Pa s"}},
    {"key_of_another_law",
     change("law = \"braid-stokes\"", "law = \"ergun\"\nfit_velocity = \"0.1 m/s\""),
     2,
     {"porous.fit_velocity: unknown key"}},
    {"unknown_quadratic_drag",
     change("law = \"braid-stokes\"", "quadratic = \"component\""),
     2,
     {"porous.quadratic = \"component\" is not known; known are speed, normal"}},
    {"unknown_export",
     change("\"vtk\"", "\"gmsh\""),
     2,
     {"case.toml:20: export.format = \"gmsh\" is not known; known are vtk, openvdb, openfoam, "
      "lattice, surfaces"}},
    {"unknown_surface",
     change("\"vtk\"", "\"surfaces\"\nparts = [\"wire\"]"),
     2,
     {"case.toml:21: export.parts: \"wire\" is not known; did you mean \"wires\"?"}},
    {"surface_twice",
     change("\"vtk\"", "\"surfaces\"\nparts = [\"wires\", \"wires\"]"),
     2,
     {"case.toml:21: export.parts: \"wires\" is given twice"}},
    {"no_surface",
     change("\"vtk\"", "\"surfaces\"\nparts = []"),
     2,
     {"export.parts is empty; known are vessel, device, wires, distance"}},
    {"unknown_braid_pattern",
     change("\"vtk\"", "\"surfaces\"\nbraid_pattern = \"4-over-4\""),
     2,
     {"case.toml:21: export.braid_pattern = \"4-over-4\" is not known"}},
    {"wires_of_two_facets",
     change("\"vtk\"", "\"surfaces\"\nwire_facets = 2"),
     2,
     {"case.toml:21: export.wire_facets = 2 is out of range; allowed are 3 to 64"}},
    {"wires_of_one_piece",
     change("\"vtk\"", "\"surfaces\"\nwire_pieces = 1"),
     2,
     {"case.toml:21: export.wire_pieces = 1 is out of range; allowed are 2 to 64"}},
    {"too_many_wire_triangles",
     change("\"vtk\"", "\"surfaces\"\nwire_pieces = 64\nwire_facets = 64"),
     2,
     {"export.wire_facets = 64 and export.wire_pieces = 64 would make wires.stl of",
      "20 million at most"}},
    {"pattern_does_not_close",
     [](Workplace& work) {
         work.replace("\"vtk\"", "\"surfaces\"");
         work.replace("\"4 mm\"", "\"4 mm\"\nnum_wires = 50");
     },
     2,
     {"export.braid_pattern = \"2-over-2\" does not close around a braid of 50 wires"}},
    {"shell_without_thickness",
     change("\"vtk\"", "\"surfaces\"\nshell_thickness = \"0 mm\""),
     2,
     {"case.toml:21: export.shell_thickness = 0 m is out of range; it must be positive"}},
    {"distance_too_coarse",
     change("\"vtk\"", "\"surfaces\"\nparts = [\"distance\"]\ndistance_spacing = \"1 mm\""),
     2,
     {"export.distance_spacing = 1 mm is too coarse for an opening of radius 1.8"}},
    {"voxels_too_small_for_openvdb",
     [](Workplace& work) {
         work.replace("\"mm\"", "\"m\"");
         work.replace("\"0.2 mm\"", "\"5 um\"");
     },
     2,
     {"grid.spacing = 0.005 mm is 5e-06 of the vessel's length unit, m; OpenVDB takes voxels of"}},
    {"unknown_lattice_target",
     change("\"vtk\"", "\"lattice\"\ntargets = [\"openlp\"]"),
     2,
     {"case.toml:21: export.targets: \"openlp\" is not known; did you mean \"openlb\"?"}},
    {"no_lattice_target",
     change("\"vtk\"", "\"lattice\"\ntargets = []"),
     2,
     {"export.targets is empty; known are numpy, openlb, palabos, walberla, hemoflow, lbpm"}},
    {"unknown_lattice_openings",
     change("\"vtk\"", "\"lattice\"\nopenings = \"extend\""),
     2,
     {"export.openings = \"extend\" is not known; did you mean \"extended\"?"}},
    {"lattice_velocity_too_high",
     change("\"vtk\"", "\"lattice\"\nvelocity_lu = 0.5"),
     2,
     {"export.velocity_lu = 0.5 is out of range", "0.2 at most"}},
    {"waveform_is_absent",
     change("\"vtk\"", "\"openfoam\"\nwaveform = \"absent.csv\""),
     5,
     {"absent.csv cannot be read"}},
    {"waveform_is_no_table",
     change("\"vtk\"", "\"openfoam\"\nwaveform = \"case.toml\""),
     3,
     {"case.toml:1: ", "is not the header of a flow waveform", "time_s,flow_rate_mL_s"}},
    {"more_outlets_than_there_are",
     change("\"vtk\"", "\"openfoam\"\noutlet_shares = [0.5, 0.5]"),
     3,
     {"2 outlet shares for 1 outlet"}},
    {"export_twice",
     add("[[export]]\nformat = \"vtk\"\n"),
     2,
     {"case.toml:22: export.format = \"vtk\" is given twice"}},
    {"ends_that_no_line_joins",
     change("length_unit", "from = 1\nto = 1\nlength_unit"),
     2,
     {"centerline.vtp", "no centerline of the file runs from opening 1 to opening 1",
      "0: from opening"}},
    {"ends_and_line_number",
     change("length_unit", "from = 0\nto = 1\ncenterline_line = 0\nlength_unit"),
     2,
     {"case.toml:5: vessel.centerline_line and vessel.from"}},
    {"one_end_only",
     change("centerline = \"centerline.vtp\"", "from = 0"),
     2,
     {"case.toml:4: vessel.from is given without its counterpart"}},
    {"end_is_no_opening",
     change("centerline = \"centerline.vtp\"", "from = 0\nto = 7"),
     2,
     {"7 is no opening of the vessel", "0: diameter", "1: diameter"}},
    {"not_toml", change("[device]", "[device"), 2, {"case.toml:5: not valid TOML"}},
    {"malformed_override",
     nothing,
     2,
     {"--set \"device\" is not of the form section.key=value"},
     {"--set", "device"}},

    // Files.
    {"vessel_missing", change("vessel.stl", "absent.stl"), 5, {"absent.stl"}},
    {"vessel_ending_unknown",
     [](Workplace& work) {
         fs::copy_file(work.path() / "vessel.stl", work.path() / "vessel.step");
         work.replace("vessel.stl", "vessel.step");
     },
     3,
     {"vessel.step", "stl"}},
    {"vessel_truncated",
     [](Workplace& work) { work.truncate("vessel.stl", 0.5); },
     5,
     {"vessel.stl"}},
    {"vessel_empty_file", [](Workplace& work) { work.write("vessel.stl", ""); }, 5, {"vessel.stl"}},
    {"centerline_missing", change("centerline.vtp", "absent.vtp"), 5, {"absent.vtp"}},
    {"centerline_truncated",
     [](Workplace& work) { work.truncate("centerline.vtp", 0.5); },
     5,
     {"centerline.vtp"}},
    {"centerline_without_a_line",
     [](Workplace& work) {
         work.write(
             "centerline.vtk",
             "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n");
         work.replace("centerline.vtp", "centerline.vtk");
     },
     3,
     {"centerline.vtk"}},
    {"centerline_line_out_of_range",
     change("length_unit", "centerline_line = 5\nlength_unit"),
     3,
     {"centerline.vtp", "5"}},

    // Shapes.
    {"mesh_empty", [](Workplace& work) { work.use_mesh({}); }, 3, {"vessel.stl", "no triangles"}},
    {"mesh_with_nan",
     [](Workplace& work) {
         TriangleMesh mesh = straight_tube();
         mesh.points[7].y() = std::numeric_limits<double>::quiet_NaN();
         work.use_mesh(mesh);
     },
     3,
     {"vessel.stl", "finite"}},
    {"mesh_closed_without_caps",
     [](Workplace& work) {
         work.use_mesh(sphere(5e-3));
         work.replace("centerline = \"centerline.vtp\"", "");
     },
     3,
     {"vessel.stl", "caps"}},
    {"mesh_non_manifold",
     [](Workplace& work) {
         TriangleMesh mesh = straight_tube();
         mesh.points.emplace_back(5e-3, 0, 10e-3);
         mesh.triangles.push_back({480, 481, static_cast<int>(mesh.points.size()) - 1});
         work.use_mesh(mesh);
     },
     3,
     {"vessel.stl", "non-manifold"}},
    {"mesh_with_a_hole",
     [](Workplace& work) {
         TriangleMesh mesh = straight_tube();
         mesh.triangles.erase(mesh.triangles.begin() + 2000);
         work.use_mesh(mesh);
     },
     3,
     {"vessel.stl", "hole"}},
    {"mesh_in_metres_declared_as_mm",
     [](Workplace& work) { work.use_mesh(straight_tube(), 1.0); },
     3,
     {"vessel.stl", "0.5", "30 mm"}},
    {"mesh_in_mm_declared_as_metres",
     change("length_unit = \"mm\"", "length_unit = \"m\""),
     3,
     {"vessel.stl", "0.5", "30 mm"}},
    {"centerline_outside_the_vessel",
     [](Workplace& work) {
         work.write("line.csv", "x,y,z\n0,0,1\n0,9,10\n0,0,24\n");
         work.replace("centerline.vtp", "line.csv");
     },
     3,
     {"line.csv", "lies off the vessel"}},
    {"landing_zone_off_the_vessel",
     change("\"23 mm\"", "\"100 mm\""),
     3,
     {"100 mm along the centerline"}},
    {"landing_zone_too_far_proximal",
     change("\"23 mm\"", "\"5 mm\""),
     3,
     {"from -15", "to 5 mm along the centerline"}},
    {"device_longer_than_the_vessel",
     change("\"20 mm\"", "\"35 mm\""),
     3,
     {"along the centerline", "a shorter device"}},
    {"device_too_small",
     change("\"4 mm\"", "\"3 mm\""),
     3,
     {"device.diameter = 3 mm is too small"}},
    {"device_too_large",
     change("\"4 mm\"",
            "\"8 mm\"\nany_size = true\nsurface_coefficient = \"0.4 N/m\"\n"
            "radial_coefficient = \"0.08 N/m\""),
     3,
     {"device.diameter = 8 mm is too large"}},
    {"catheter_too_wide",
     nothing,
     3,
     {"catheter of 3.8 mm"},
     {"--set", "device.catheter_diameter=3.8 mm"}},

    // Convergence.
    {"deployment_does_not_settle",
     nothing,
     4,
     {"did not come to rest", "tolerance", "max_settling_steps"},
     {"--set", "deployment.max_settling_steps=1", "--set", "deployment.release_interval=1"}},
};

class BadInputTest : public testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, EndsWithItsStatusAndMessageAndLeavesNothing)
{
    const BadInput& bad = GetParam();
    Workplace work;
    bad.spoil(work);
    std::vector<std::string> arguments = {"run", (work.path() / "case.toml").string()};
    arguments.insert(arguments.end(), bad.arguments.begin(), bad.arguments.end());
    const test::Program program(arguments, work.path());
    EXPECT_EQ(program.wait(), bad.status) << program.err();
    for (const std::string& piece : bad.pieces) {
        EXPECT_NE(program.err().find(piece), std::string::npos)
            << "\"" << piece << "\" is not in: " << program.err();
    }
    for (const auto& entry : fs::directory_iterator(work.path())) {
        EXPECT_FALSE(entry.is_directory()) << entry.path() << " was left";
    }
}

INSTANTIATE_TEST_SUITE_P(Table, BadInputTest, testing::ValuesIn(bad_inputs),
                         [](const auto& bad) { return bad.param.name; });

/// Runs the untouched case with arguments after `run case.toml`.
int run(const Workplace& work, std::vector<std::string> arguments, std::string& message)
{
    arguments.insert(arguments.begin(), {"run", (work.path() / "case.toml").string()});
    const test::Program program(arguments, work.path());
    const int status = program.wait();
    message = program.err();
    return status;
}

TEST(BadCommandLine, EndsWithStatus2)
{
    const test::TemporaryFolder folder;
    const std::vector<std::pair<std::vector<std::string>, std::string>> commands = {
        {{}, "subcommand"},
        {{"calibrate", "case.toml"}, "--measured is required"},
        {{"diagnose", "case.toml"},
         "takes one of --measured, --force-curve and --pressure-drop; 0 are given"},
        {{"diagnose", "case.toml", "--separability", "--measured", "m.csv"},
         "leave --measured, --scalars and --density-map out"},
        {{"stent", "case.toml"}, "stent"},
        {{"run"}, "CASE is required"},
        {{"run", "case.toml", "--colour"}, "--colour"},
        {{"run", "case.toml", "--threads", "0"}, "--threads"},
        {{"run", "case.toml", "--threads", "two"}, "--threads"},
        {{"devices", "pipline-flex"}, "did you mean \"pipeline-flex\"?"},
        {{"centerline", "v.stl", "--from", "0"}, "--from and --to"},
        {{"centerline", "v.stl", "--from", "0", "--to", "here"}, "--to \"here\""},
        {{"centerline", "v.stl", "--length-unit", "inch"}, "m, cm, mm, um"},
    };
    for (const auto& [arguments, piece] : commands) {
        const test::Program program(arguments, folder.path());
        EXPECT_EQ(program.wait(), 2) << program.err();
        EXPECT_NE(program.err().find(piece), std::string::npos) << program.err();
    }
}

TEST(BadCommandLine, EndsWithStatus5WithoutACaseFile)
{
    const test::TemporaryFolder folder;
    const test::Program program({"run", (folder.path() / "absent.toml").string()}, folder.path());
    EXPECT_EQ(program.wait(), 5);
    EXPECT_NE(program.err().find("absent.toml cannot be opened"), std::string::npos);
}

TEST(Output, CannotBeBelowAFile)
{
    const Workplace work;
    std::string message;
    EXPECT_EQ(run(work, {"--output", (work.path() / "vessel.stl" / "out").string()}, message), 5);
    EXPECT_NE(message.find("cannot be created"), std::string::npos) << message;
}

TEST(Output, CannotBeAFile)
{
    const Workplace work;
    std::string message;
    EXPECT_EQ(run(work, {"--output", (work.path() / "vessel.stl").string()}, message), 5);
    EXPECT_NE(message.find("is a file"), std::string::npos) << message;
}

TEST(Output, OfAnotherOriginIsReplacedByForceOnly)
{
    const Workplace work;
    work.write("case.out/notes.txt", "mine");
    std::string message;
    EXPECT_EQ(run(work, {}, message), 5);
    EXPECT_NE(message.find("no earlier run wrote it"), std::string::npos) << message;
    EXPECT_TRUE(fs::exists(work.output() / "notes.txt"));

    work.write("case.out/summary.json", "{\"program\": \"another\"}");
    EXPECT_EQ(run(work, {}, message), 5);

    EXPECT_EQ(run(work, {"--force"}, message), 0) << message;
    EXPECT_FALSE(fs::exists(work.output() / "notes.txt"));
    EXPECT_TRUE(fs::exists(work.output() / "device.vtp"));
}

TEST(Output, OfAnEarlierRunIsReplacedAndSurvivesAFailure)
{
    const Workplace work;
    std::string message;
    ASSERT_EQ(run(work, {}, message), 0) << message;
    work.write("case.out/mark", "first");
    EXPECT_EQ(
        run(work,
            {"--set", "deployment.max_settling_steps=1", "--set", "deployment.release_interval=1"},
            message),
        4);
    EXPECT_TRUE(fs::exists(work.output() / "mark"));
    EXPECT_TRUE(fs::exists(work.output() / "summary.json"));
    // The user's own file stays beside the new results.
    const auto before = fs::last_write_time(work.output() / "device.vtp");
    EXPECT_EQ(run(work, {}, message), 0) << message;
    EXPECT_TRUE(fs::exists(work.output() / "mark"));
    EXPECT_NE(fs::last_write_time(work.output() / "device.vtp"), before);
}

/// True once the program has made its hidden folder.
bool has_begun(const Workplace& work)
{
    for (const auto& entry : fs::directory_iterator(work.path())) {
        if (entry.is_directory() && entry.path().filename().string().starts_with(".braidzone.")) {
            return true;
        }
    }
    return false;
}

TEST(Output, OfAnInterruptedRunIsAbsentAndTheEarlierOneUntouched)
{
    for (const int signal : {SIGTERM, SIGINT}) {
        Workplace work;
        std::string message;
        ASSERT_EQ(run(work, {}, message), 0) << message;
        work.write("case.out/mark", "first");
        // Slow enough to be interrupted: a ring is released every 100000 steps.
        const test::Program program(
            {"run", (work.path() / "case.toml").string(), "--set",
             "deployment.release_interval=100000", "--set", "deployment.residual_tolerance=1e-15"},
            work.path());
        while (!has_begun(work))
            ::usleep(1000);
        ::usleep(50000);
        program.send(signal);
        EXPECT_EQ(program.wait(), 128 + signal);
        EXPECT_FALSE(has_begun(work));
        EXPECT_TRUE(fs::exists(work.output() / "mark"));
    }
}

TEST(Output, OfAFirstInterruptedRunIsAbsent)
{
    Workplace work;
    const test::Program program(
        {"run", (work.path() / "case.toml").string(), "--set", "deployment.release_interval=100000",
         "--set", "deployment.residual_tolerance=1e-15"},
        work.path());
    while (!has_begun(work))
        ::usleep(1000);
    program.send(SIGTERM);
    EXPECT_EQ(program.wait(), 128 + SIGTERM);
    EXPECT_FALSE(has_begun(work));
    EXPECT_FALSE(fs::exists(work.output()));
}

}  // namespace
}  // namespace braidzone

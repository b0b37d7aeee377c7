// What each verb writes and prints, on the shipped straight tube.

#include "cli/case_geometry.hpp"
#include "core/surface_io.hpp"
#include "core/wall_tree.hpp"
#include "support/program.hpp"
#include "support/python.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class Verbs : public testing::Test {
protected:
    void SetUp() override
    {
        const fs::path shipped = fs::path(BRAIDZONE_SOURCE_DIR) / "cases" / "straight_tube";
        for (const char* file : {"vessel.stl", "centerline.vtp", "case.toml"}) {
            fs::copy_file(shipped / file, folder_.path() / file);
        }
    }

    /// Runs a verb on the case at 0.2 mm voxels, with further arguments.
    void run(const std::string& verb, const Words& more = {})
    {
        Words words = {verb, (folder_.path() / "case.toml").string(), "--set",
                       "grid.spacing=0.2 mm"};
        words.insert(words.end(), more.begin(), more.end());
        start(words);
    }

    void start(const Words& words)
    {
        const test::Program program(words, folder_.path());
        const int status = program.wait();
        out_ = program.out();
        ASSERT_EQ(status, 0) << program.err();
    }

    static std::string text_of(const fs::path& file)
    {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return std::move(text).str();
    }

    nlohmann::json summary(const std::string& output = "case.out") const
    {
        return nlohmann::json::parse(text_of(folder_.path() / output / "summary.json"));
    }

    bool is_there(const std::string& file) const { return fs::exists(folder_.path() / file); }

    test::TemporaryFolder folder_;
    std::string out_;
};

TEST_F(Verbs, DeployWritesTheDeviceOnly)
{
    run("deploy");
    for (const char* file : {"device.vtp", "wires.vtp", "unrolled.vtp", "unrolled.png"}) {
        EXPECT_TRUE(is_there(std::string("case.out/") + file)) << file;
    }
    EXPECT_FALSE(is_there("case.out/field.vdb"));
    EXPECT_FALSE(is_there("case.out/openfoam"));
    const auto quantities = summary()["quantities"];
    EXPECT_TRUE(quantities["resistance_integral_field"].is_null());
    EXPECT_EQ(quantities["implanted_length"]["unit"], "m");
}

TEST_F(Verbs, PorousWritesTheFieldsToo)
{
    run("porous");
    EXPECT_TRUE(is_there("case.out/field.vdb"));
    EXPECT_TRUE(is_there("case.out/field.vti"));
    EXPECT_FALSE(is_there("case.out/openfoam"));
    EXPECT_FALSE(summary()["quantities"]["resistance_integral_field"].is_null());
}

TEST_F(Verbs, PorousComparesTheLaws)
{
    run("porous", {"--compare-laws"});
    EXPECT_TRUE(is_there("case.out/laws.png"));
    const auto files = summary()["files"].get<Words>();
    EXPECT_NE(std::find(files.begin(), files.end(), "laws.csv"), files.end());
    std::istringstream table(text_of(folder_.path() / "case.out/laws.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line,
              "law,a_Pa_s_per_m,b_Pa_s2_per_m2,drop_at_10_mm_s_Pa,drop_at_50_mm_s_Pa,"
              "drop_at_100_mm_s_Pa,drop_at_200_mm_s_Pa,a_over_recommended,resistance_integral_m");
    Words laws;
    while (std::getline(table, line)) {
        laws.push_back(line.substr(0, line.find(',')));
        EXPECT_NE(out_.find("\n  " + laws.back() + " "), std::string::npos) << out_;
    }
    EXPECT_EQ(laws, (Words{"braid-stokes", "brundrett", "gedeon-wood", "ergun", "idelchik",
                           "armour-cannon"}));
}

TEST_F(Verbs, RunWritesEverythingAndListsIt)
{
    run("run");
    const auto record = summary();
    const auto files = record["files"].get<Words>();
    for (const char* file : {"device.vtp", "field.vdb", "field.vti", "openfoam/Allrun",
                             "openfoam/braidzone/case.toml", "unrolled.png", "wires.vtp"}) {
        EXPECT_TRUE(is_there(std::string("case.out/") + file)) << file;
        EXPECT_NE(std::find(files.begin(), files.end(), file), files.end()) << file;
    }
    EXPECT_EQ(record["inputs"].size(), 3u);
    EXPECT_EQ(record["case"]["vessel"]["surface"], (folder_.path() / "vessel.stl").string());
    // A straight tube holds the device at its nominal length.
    EXPECT_NEAR(record["quantities"]["implanted_length"]["value"].get<double>(), 20e-3, 0.1e-3);
    EXPECT_NE(out_.find("implanted length"), std::string::npos);
}

TEST_F(Verbs, RunWritesTheFieldsAlwaysAndSolverCasesAsWanted)
{
    const std::string text = text_of(folder_.path() / "case.toml");
    folder_.write("case.toml",
                  text.substr(0, text.find("[[export]]")) + "[[export]]\nformat = \"openvdb\"\n");
    run("run");
    EXPECT_TRUE(is_there("case.out/field.vdb"));
    EXPECT_TRUE(is_there("case.out/field.vti"));
    EXPECT_FALSE(is_there("case.out/openfoam"));
}

TEST_F(Verbs, RunKeepsTheWaveformWithTheCase)
{
    const std::string text = text_of(folder_.path() / "case.toml");
    const std::string waveform = "time_s,flow_rate_mL_s\n0,3\n0.3,6\n0.8,3\n";
    folder_.write("wave.csv", waveform);
    folder_.write("case.toml", text.substr(0, text.find("[[export]]")) +
                                   "[[export]]\nformat = \"openfoam\"\nwaveform = \"wave.csv\"\n");
    run("run", {"--set", "fluid.rheology=carreau-yasuda"});
    EXPECT_EQ(text_of(folder_.path() / "case.out/openfoam/braidzone/flow.csv"), waveform);
    const auto record = summary();
    const auto inputs = record["inputs"];
    EXPECT_NE(inputs.dump().find("wave.csv"), std::string::npos) << inputs;
    EXPECT_NE(out_.find("note: carreau-yasuda: "), std::string::npos) << out_;
    // The copy is a case of its own. Mean of the triangles: 4.5 mL/s.
    start({"check", (folder_.path() / "case.out/openfoam/braidzone/case.toml").string()});
    EXPECT_NE(out_.find("inlet, opening 1: pulsatile inflow, mean 4.5 mL/s in"), std::string::npos)
        << out_;
    EXPECT_NE(out_.find("openfoam    outlet_1, opening 0: pressure 0 Pa"), std::string::npos)
        << out_;
    EXPECT_NE(out_.find("3 cycles of 0.8 s"), std::string::npos) << out_;
    EXPECT_NE(out_.find("note: carreau-yasuda: "), std::string::npos) << out_;
}

TEST_F(Verbs, RunWritesTheLatticeIfAsked)
{
    std::ofstream(folder_.path() / "case.toml", std::ios::app)
        << "\n[[export]]\nformat = \"lattice\"\ntargets = [\"openlb\", \"numpy\"]\n";
    run("run");
    const auto record = summary();
    const auto files = record["files"].get<Words>();
    for (const char* file :
         {"lattice/lattice.json", "lattice/numpy/darcy.npy", "lattice/openlb/olb_porosity.vdb"}) {
        EXPECT_NE(std::find(files.begin(), files.end(), file), files.end()) << file;
    }
    EXPECT_FALSE(is_there("case.out/lattice/palabos"));
    const auto lattice =
        nlohmann::json::parse(text_of(folder_.path() / "case.out/lattice/lattice.json"));
    EXPECT_EQ(lattice["notes"].size(), 1U);  // the relaxation time; on the wall nothing resists
    for (const auto& note : lattice["notes"]) {
        EXPECT_NE(out_.find(note.get<std::string>()), std::string::npos) << note;
    }
}

/// Reads what view.py shows with VTK's own readers, and looks for the arrays that it colours by.
constexpr auto read_view = R"(import ast, vtk
tree = ast.parse(open('view.py').read())
constants = {n.targets[0].id: ast.literal_eval(n.value) for n in tree.body
             if isinstance(n, ast.Assign) and getattr(n.targets[0], 'id', '') in ('DEVICES', 'FIELD')}
for name in ['vessel.vtp'] + constants['DEVICES'] + [constants['FIELD']]:
    kind = vtk.vtkXMLImageDataReader if name.endswith('.vti') else vtk.vtkXMLPolyDataReader
    reader = kind()
    reader.SetFileName(name)
    reader.Update()
    data = reader.GetOutput()
    cells = data.GetCellData()
    wanted = {'vessel.vtp': ['opening'], 'field.vti': ['darcy_normal', 'cell_type']}
    for array in wanted.get(name, ['metal_coverage']):
        assert cells.GetArray(array), (name, array)
    fields = data.GetFieldData()
    print(name, cells.GetScalars().GetName(), fields.GetAbstractArray('length_unit').GetValue(0))
    for i in range(cells.GetNumberOfArrays()):
        assert fields.GetAbstractArray('unit:' + cells.GetArrayName(i)), cells.GetArrayName(i)
)";

TEST_F(Verbs, RunWritesAViewForParaviewOfFilesThatVtkReads)
{
    run("run");
    EXPECT_EQ(test::printed_by_python(folder_.path() / "case.out", read_view),
              "vessel.vtp opening mm\n"
              "device.vtp metal_coverage mm\n"
              "field.vti darcy_normal mm\n");
}

// A phantom end to end: the straight tube of 3.7 mm with its device on the wall.
TEST_F(Verbs, RunWritesTheSurfacesIfAsked)
{
    std::ofstream(folder_.path() / "case.toml", std::ios::app)
        << "\n[[export]]\nformat = \"surfaces\"\n";
    run("run");
    const fs::path surfaces = folder_.path() / "case.out" / "surfaces";
    const auto record = summary();
    const auto files = record["files"].get<Words>();
    for (const char* file : {"surfaces/vessel.stl", "surfaces/device.stl", "surfaces/wires.stl",
                             "surfaces/vessel_distance.vdb", "surfaces/surfaces.json"}) {
        EXPECT_NE(std::find(files.begin(), files.end(), file), files.end()) << file;
    }
    const auto json = nlohmann::json::parse(text_of(surfaces / "surfaces.json"));
    EXPECT_TRUE(json["notes"].empty()) << json["notes"];
    EXPECT_EQ(json["case_hash"], record["case_hash"]);
    const auto& wires = json["files"]["wires.stl"];
    EXPECT_EQ(wires["num_solids"], 48);
    EXPECT_GT(wires["least_gap_m"].get<double>(), 0.0);
    // Half of the arms of 0.264 mm go from over to under by 2 h = 33 um, which makes wires longer
    // by (pi h / a)^2 / 4 = 1.0 %. A braid 34 um further inwards has 1.8 % less circumference, of
    // which wires at 23.5 degrees lose cos^2, 1.5 %.
    const double metal = record["quantities"]["metal_volume"]["value"];
    EXPECT_NEAR(wires["volume_m3"].get<double>() / metal, 1.0 + 0.010 - 0.015, 0.004);
    const TriangleMesh lumen = read_surface(surfaces / "vessel.stl", LengthUnit{"mm", 1e-3});
    EXPECT_EQ(lumen.triangles.size(), json["files"]["vessel.stl"]["num_triangles"]);
    EXPECT_NEAR(enclosed_volume(lumen), std::numbers::pi * 1.85e-3 * 1.85e-3 * 26e-3,
                0.01 * 2.8e-7);
    // The wires as a voxeliser finds them: none outside the lumen.
    VesselSource source;
    source.surface = folder_.path() / "vessel.stl";
    source.unit = LengthUnit{"mm", 1e-3};
    const WallTree wall(read_vessel(source));
    const TriangleMesh tubes = read_surface(surfaces / "wires.stl", LengthUnit{"mm", 1e-3});
    for (std::size_t i = 0; i < tubes.points.size(); i += 7)
        ASSERT_TRUE(wall.contains(tubes.points[i])) << i;
}

// The straight tube lies along x, so that both openings turn by 90 degrees.
TEST_F(Verbs, RunContinuesTheOpeningsIfAsked)
{
    std::ofstream(folder_.path() / "case.toml", std::ios::app)
        << "\n[[export]]\nformat = \"lattice\"\ntargets = [\"lbpm\", \"hemoflow\"]\n"
           "openings = \"extended_z\"\n";
    run("check");
    EXPECT_NE(out_.find(" nodes, "), std::string::npos) << out_;
    EXPECT_NE(out_.find("turned by 90 degrees, to the lower face of the box across z"),
              std::string::npos)
        << out_;
    run("run");
    EXPECT_NE(out_.find("turned by 90 degrees, to the upper face of the box across z"),
              std::string::npos)
        << out_;
    const auto lattice =
        nlohmann::json::parse(text_of(folder_.path() / "case.out/lattice/lattice.json"));
    EXPECT_EQ(lattice["openings"][0]["normal_outwards"][2].get<double>(),
              -lattice["openings"][1]["normal_outwards"][2].get<double>());
    EXPECT_TRUE(is_there("case.out/lattice/lbpm/permeability_vox2_f64.raw"));
    EXPECT_TRUE(is_there("case.out/lattice/hemoflow/case.npz"));
}

TEST_F(Verbs, CheckRefusesALatticeThatIsTooLarge)
{
    std::ofstream(folder_.path() / "case.toml", std::ios::app)
        << "\n[[export]]\nformat = \"lattice\"\n";
    const test::Program program(
        {"check", (folder_.path() / "case.toml").string(), "--set", "grid.spacing=5 um"},
        folder_.path());
    EXPECT_EQ(program.wait(), 2);
    EXPECT_NE(program.err().find("at most 5e+08 nodes are allowed, as with a spacing of"),
              std::string::npos)
        << program.err();
}

TEST_F(Verbs, GiveTheSameBytesWhateverTheNumberOfThreads)
{
    std::ofstream(folder_.path() / "case.toml", std::ios::app)
        << "\n[[export]]\nformat = \"surfaces\"\n";
    const auto output = [&](const char* name) { return (folder_.path() / name).string(); };
    run("run", {"--threads", "1", "--output", output("one")});
    run("run", {"--threads", "2", "--output", output("two")});
    for (const auto& file : summary("one")["files"].get<Words>()) {
        EXPECT_EQ(text_of(folder_.path() / "one" / file), text_of(folder_.path() / "two" / file))
            << file;
    }
    EXPECT_EQ(summary("one")["quantities"]["resistance_integral_field"],
              summary("two")["quantities"]["resistance_integral_field"]);
}

TEST_F(Verbs, TheCopiedCaseGivesTheIdenticalDeployment)
{
    run("run");
    const fs::path copy = folder_.path() / "case.out" / "openfoam" / "braidzone";
    start(
        {"deploy", (copy / "case.toml").string(), "--output", (folder_.path() / "again").string()});
    for (const char* file : {"device.vtp", "wires.vtp"}) {
        EXPECT_EQ(text_of(folder_.path() / "again" / file),
                  text_of(folder_.path() / "case.out" / file))
            << file;
    }
}

TEST_F(Verbs, QuietPrintsNothing)
{
    run("deploy", {"--quiet"});
    EXPECT_EQ(out_, "");
}

TEST_F(Verbs, CheckPrintsWhatItFoundAndWritesNothing)
{
    run("check");
    for (const char* piece :
         {"2 openings", "0: diameter 3.69 mm at (26.00, ", "1: diameter 3.69 mm at (0.00, ",
          "from opening", "pipeline-flex 4 x 20 mm", "48 wires of 30 um",
          "to 23 mm along the centerline",
          "resistance  braid-stokes, where the device is free of the wall; tangential ratio 1",
          "million voxels"}) {
        EXPECT_NE(out_.find(piece), std::string::npos) << piece << " is not in\n" << out_;
    }
    EXPECT_FALSE(is_there("case.out"));
}

TEST_F(Verbs, CenterlineComputesAFileThatARunAccepts)
{
    const std::string line = (folder_.path() / "line.vtp").string();
    start({"centerline", (folder_.path() / "vessel.stl").string(), "--from", "0", "--to", "1",
           "--output", line});
    run("deploy", {"--set", "vessel.centerline=line.vtp"});
    EXPECT_NEAR(summary()["quantities"]["contact_area_fraction"]["value"].get<double>(), 1.0, 0.01);

    // A file that is there is not overwritten.
    const test::Program again(
        {"centerline", (folder_.path() / "vessel.stl").string(), "--output", line}, folder_.path());
    EXPECT_EQ(again.wait(), 5);
    EXPECT_NE(again.err().find("line.vtp exists"), std::string::npos) << again.err();
}

TEST_F(Verbs, PhantomWritesAVesselThatCheckAccepts)
{
    const fs::path parameters =
        fs::path(BRAIDZONE_SOURCE_DIR) / "cases" / "straight_tube" / "phantom.toml";
    const fs::path made = folder_.path() / "made";
    start({"phantom", parameters.string(), "--output", made.string()});
    fs::copy_file(folder_.path() / "case.toml", made / "case.toml");
    start({"check", (made / "case.toml").string()});
    EXPECT_NE(out_.find("2 openings"), std::string::npos) << out_;
    for (const auto& entry : fs::directory_iterator(made)) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
    }
}

TEST_F(Verbs, DevicesListsAndShows)
{
    start({"devices"});
    EXPECT_NE(out_.find("pipeline-flex"), std::string::npos);
    EXPECT_NE(out_.find("incomplete"), std::string::npos);
    start({"devices", "pipeline-flex"});
    EXPECT_NE(out_.find("confidence high: Zavodszky et al. 2020"), std::string::npos);
}

}  // namespace
}  // namespace braidzone

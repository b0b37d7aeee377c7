// Each file of a lattice is read back by a program that is not ours: NumPy, VTK, OpenVDB.

#include "core/error.hpp"
#include "export/lattice_arrays.hpp"
#include "export/lattice_export.hpp"
#include "export/lattice_hemoflow.hpp"
#include "export/lattice_openlb.hpp"
#include "support/braids.hpp"
#include "support/lattices.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace braidzone {
namespace {

namespace fs = std::filesystem;

class LatticeExport : public ::testing::Test {
protected:
    fs::path folder() const { return folder_.path(); }

    std::string text_of(const fs::path& path) const
    {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return std::move(text).str();
    }

    /// What a Python script prints, run in the folder.
    std::string printed_by_python(const std::string& script) const
    {
        std::ofstream(folder() / "script.py") << script;
        const std::string command =
            fmt::format("cd '{}' && /usr/bin/python3 script.py > printed", folder().string());
        EXPECT_EQ(std::system(command.c_str()), 0) << script;
        return text_of(folder() / "printed");
    }

    /// Calls visit(i, j, k, index) for x slowest.
    template <typename Visit>
    void for_each_node(Visit visit) const
    {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 4; ++j)
                for (int k = 0; k < 5; ++k)
                    visit(i, j, k, nodes.grid.index(i, j, k));
    }

    double expected_darcy(std::size_t index) const
    {
        for (std::size_t i = 0; i < nodes.resisting.size(); ++i)
            if (nodes.resisting[i] == static_cast<std::int64_t>(index)) return nodes.darcy[i];
        return 0.0;
    }

    LatticeNodes nodes = test::asymmetric_lattice();

private:
    test::TemporaryFolder folder_;
};

TEST_F(LatticeExport, NumpyReadsEveryNodeAtItsPlace)
{
    write_lattice_arrays(folder(), nodes);
    std::istringstream printed(printed_by_python(
        "import numpy as n\n"
        "t, d = n.load('cell_type.npy'), n.load('darcy.npy')\n"
        "f, o = n.load('forchheimer.npy'), n.load('normal.npy')\n"
        "print(t.dtype, d.dtype, f.dtype, o.dtype)\n"
        "print(*t.shape, *d.shape, *o.shape)\n"
        "for i in range(3):\n"
        "  for j in range(4):\n"
        "    for k in range(5): print(t[i,j,k], d[i,j,k], f[i,j,k], *o[:,i,j,k])\n"));
    std::string line;
    std::getline(printed, line);
    EXPECT_EQ(line, "uint8 float32 float32 float32");
    std::getline(printed, line);
    EXPECT_EQ(line, "3 4 5 3 4 5 3 3 4 5");
    for_each_node([&](int i, int j, int k, std::size_t index) {
        int type = -1;
        double darcy = -1.0, forchheimer = -1.0;
        Vec3 normal;
        printed >> type >> darcy >> forchheimer >> normal[0] >> normal[1] >> normal[2];
        EXPECT_EQ(type, nodes.type[index]) << i << j << k;
        EXPECT_EQ(darcy, expected_darcy(index)) << i << j << k;
        const bool first = i == 1 && j == 2 && k == 3, second = i == 2 && j == 0 && k == 4;
        EXPECT_EQ(forchheimer, first ? 6144.0 : second ? 7168.0 : 0.0);
        EXPECT_EQ(normal, first ? nodes.normal[0] : second ? nodes.normal[1] : Vec3(0, 0, 0));
    });
}

// 0 fluid and openings, 1 wall, 2 unused; x slowest, a line for each x and y.
TEST_F(LatticeExport, PalabosGeometryHasXSlowest)
{
    const fs::path path = folder() / "geometry.dat";
    write_palabos_geometry(path, nodes, {{0, 0, 0}, {2, 3, 4}});
    const std::string content = text_of(path);
    std::istringstream text(content);
    for_each_node([&](int i, int j, int k, std::size_t index) {
        int value = -1;
        text >> value;
        const std::uint8_t type = nodes.type[index];
        EXPECT_EQ(value, type == 0 ? 2 : type == 1 ? 1 : 0) << i << j << k;
    });
    int beyond = 0;
    EXPECT_FALSE(text >> beyond);
    EXPECT_EQ(std::count(content.begin(), content.end(), '\n'), 3 * 4);
}

// Of the box alone: node (1, 2, 3) first.
TEST_F(LatticeExport, PalabosGeometryIsOfTheBox)
{
    const fs::path path = folder() / "geometry.dat";
    const LatticeFile file = write_palabos_geometry(path, nodes, {{1, 2, 3}, {2, 3, 4}});
    EXPECT_EQ(file.shape, (std::vector<int>{2, 2, 2}));
    std::istringstream text(text_of(path));
    for (const int i : {1, 2})
        for (const int j : {2, 3})
            for (const int k : {3, 4}) {
                int value = -1;
                text >> value;
                const std::uint8_t type = nodes.type[nodes.grid.index(i, j, k)];
                EXPECT_EQ(value, type == 0 ? 2 : type == 1 ? 1 : 0) << i << j << k;
            }
}

TEST_F(LatticeExport, WalberlaMaskHasXFastest)
{
    const fs::path path = folder() / "mask_u8.raw";
    write_walberla_mask(path, nodes);
    const std::string bytes = text_of(path);
    ASSERT_EQ(bytes.size(), nodes.type.size());
    for (std::size_t node = 0; node < bytes.size(); ++node)
        EXPECT_EQ(bytes[node], nodes.type[node] >= 2 ? 1 : 0) << node;
}

class OpenLbExport : public LatticeExport {
protected:
    const Fluid fluid{1000.0, 4e-3};
    LatticeUnits units = propose_units(nodes, fluid, {});
};

// a = 4e-6 1.5e9 dt = 0.1, tau = 0.505: d = 1 - 0.0505 / 1.05 = 0.9519048; 0.16667 for the other:
// d = 1 - 0.0841667 / 1.083333 = 0.9223077.
TEST_F(OpenLbExport, OpenVdbReadsItsPorosity)
{
    write_openlb(folder(), nodes, fluid, units);
    openvdb::initialize();
    openvdb::io::File file((folder() / "olb_porosity.vdb").string());
    file.open();
    const auto grids = file.getGrids();
    ASSERT_EQ(grids->size(), 1U);
    const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(grids->front());
    EXPECT_EQ(grid->activeVoxelCount(), 2U);
    EXPECT_NEAR(grid->tree().getValue({1, 2, 3}), 0.9519048, 1e-6);
    EXPECT_NEAR(grid->tree().getValue({2, 0, 4}), 0.9223077, 1e-6);
    EXPECT_EQ(grid->tree().getValue({0, 0, 0}), 1.0F);
    EXPECT_NEAR(grid->transform().voxelSize()[0], 0.2, 1e-12);
    EXPECT_EQ(printed_by_python("import pyopenvdb as v\n"
                                "g = v.read('olb_porosity.vdb', 'porosity')\n"
                                "print(g.activeVoxelCount())\n"),
              "2\n");
}

TEST_F(OpenLbExport, VtkReadsItsImage)
{
    write_openlb(folder(), nodes, fluid, units);
    const std::string text = text_of(folder() / "case.vti");
    EXPECT_EQ(text.find("appended"), std::string::npos);
    EXPECT_EQ(text.find("format=\"binary\""), std::string::npos);
    EXPECT_NE(text.find("format=\"ascii\""), std::string::npos);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName((folder() / "case.vti").c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    EXPECT_EQ(image->GetOrigin()[1], 0.0);
    EXPECT_NEAR(image->GetSpacing()[2], 0.2e-3, 1e-15);
    for_each_node([&](int i, int j, int k, std::size_t index) {
        int place[3] = {i, j, k};
        const vtkIdType point = image->ComputePointId(place);
        const auto value = [&](const char* name) {
            return image->GetPointData()->GetArray(name)->GetComponent(point, 0);
        };
        EXPECT_EQ(value("flags"), nodes.type[index]);
        EXPECT_EQ(value("darcy_d"), expected_darcy(index));
    });
}

// 1 / (3 nu_lu) = 200 here; a drag of 240 a step needs D = 3.6e12 1/m^2.
TEST_F(OpenLbExport, RefusesMoreDragThanItsCollisionExpresses)
{
    nodes.darcy[0] = 3.6e12;
    units = propose_units(nodes, fluid, {});
    try {
        write_openlb(folder(), nodes, fluid, units);
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("cannot express a drag of 240"));
    }
}

TEST_F(LatticeExport, NotesSayWhatTargetsLeaveOut)
{
    nodes.tangential_ratio = {5.0, 5.0};
    const Vessel vessel = test::tube_vessel(1.5e-3, 6e-3);
    nodes.openings = {{0, 10, 7}, {1, 11, 8}};
    const std::vector<std::string> notes =
        write_lattice(folder(), nodes, vessel, Fluid{1000.0, 4e-3}, {});
    EXPECT_THAT(
        notes, ::testing::Contains("lattice: openlb takes the linear part of the resistance only"));
    EXPECT_THAT(notes, ::testing::Contains(
                           ::testing::HasSubstr("openlb has one resistance for all directions")));
    EXPECT_THAT(notes, ::testing::Contains(
                           "lattice: walberla takes the walls, not the device's resistance"));
    EXPECT_THAT(notes, ::testing::Not(::testing::Contains(::testing::HasSubstr("numpy takes"))));
    // tau = 0.505: 0.0105 / 0.005 times the velocity, or of the spacing.
    EXPECT_THAT(notes, ::testing::Contains(::testing::HasSubstr(
                           "lattice (palabos, walberla): relaxation time 0.505 is not above 0.51: "
                           "the plain BGK collision is unstable")));
    for (const char* file :
         {"numpy/cell_type.npy", "numpy/README.md", "openlb/case.vti", "openlb/olb_porosity.vdb",
          "palabos/geometry.dat", "walberla/mask_u8.raw", "lattice.json"})
        EXPECT_TRUE(fs::exists(folder() / file)) << file;
    // The JSON places the arrays: origin and spacing give each node its place.
    EXPECT_EQ(
        printed_by_python("import json, numpy as n\n"
                          "c = json.load(open('lattice.json'))\n"
                          "d = n.load('numpy/darcy.npy').astype(float)\n"
                          "print(list(d.shape) == c['dims'])\n"
                          "s = d.sum() * c['spacing_m']**3\n"
                          "print(abs(s / c['resistance']['integral_of_darcy_m'] - 1) < 1e-6)\n"
                          "print(c['openings'][1]['num_nodes'], c['origin_m'][2])\n"),
        "True\nTrue\n8 0.003\n");
}

using test::TubeLattice;

// Every file is in the list with the bytes and the SHA-256 that Python finds, and arrays with their
// shape; the matrix takes the index of a node to its place.
TEST_F(LatticeExport, JsonListsTheFilesAsTheyAre)
{
    const TubeLattice tube;
    LatticeExportOptions options;
    options.targets = all_lattice_targets();
    write_lattice(folder(), tube.nodes, tube.vessel, Fluid{1055.0, 3.4e-3}, options);
    EXPECT_EQ(printed_by_python(
                  "import json, hashlib, os, numpy as n\n"
                  "c = json.load(open('lattice.json'))\n"
                  "for t in c['targets']:\n"
                  "  names = {'README.md'}\n"
                  "  for f in c['targets'][t]['files']:\n"
                  "    b = open(t + '/' + f['name'], 'rb').read()\n"
                  "    assert len(b) == f['bytes'], f\n"
                  "    assert hashlib.sha256(b).hexdigest() == f['sha256'], f\n"
                  "    if f['name'].endswith('.npy'):\n"
                  "      assert list(n.load(t + '/' + f['name']).shape) == f['shape'], f\n"
                  "    if f['name'].endswith('.raw'):\n"
                  "      size = 1 if f['type'] == 'uint8' else 8\n"
                  "      assert size * n.prod(f['shape']) == f['bytes'], f\n"
                  "    names.add(f['name'])\n"
                  "  assert names == set(os.listdir(t)), names\n"
                  "print(len(c['targets']))\n"
                  "m, o, h = n.array(c['index_to_world_m']), c['origin_m'], c['spacing_m']\n"
                  "print(m.shape, abs(m @ [1, 2, 3, 1] - [o[0] + h, o[1] + 2 * h, o[2] + 3 * h, "
                  "1]).max() < 1e-15)\n"),
              "6\n(4, 4) True\n");
}

// Opening 0 is the one at z = 0 or the other end, by the vessel's own order; whichever it is, the
// inlet's nodes fill a face of the box, the outlet's the opposite one. The weights times linCoeff
// are mu D dx, whose sum times dx^2 is mu times the Darcy integral.
TEST_F(LatticeExport, NumpyReadsWhatHemoFlowReads)
{
    const TubeLattice tube;
    const Fluid fluid{1055.0, 3.4e-3};
    write_hemoflow(folder(), tube.nodes, tube.vessel, fluid, {});
    const std::string printed = printed_by_python(
        "import numpy as n, re\n"
        "c = n.load('case.npz')\n"
        "print(*sorted(c.keys()))\n"
        "f, s = c['geometryFlag'], c['stent']\n"
        "print(f.dtype, s.dtype, f.shape == s.shape, f.flags['C_CONTIGUOUS'])\n"
        "a, b = n.argwhere(f == 10), n.argwhere(f == 11)\n"
        "print(set(a[:,2]) | set(b[:,2]) == {0, f.shape[2] - 1}, len(set(a[:,2])))\n"
        "print(c['openingIndex'].dtype, *c['openingIndex'], c['openingQRatio'.replace('Q', "
        "'NormalizedQ')][1])\n"
        "t, m = c['openingTangent'], c['openingCenter']\n"
        "print(abs(t[0] - t[1]).max() < 1e-6, abs(m[0] - a.mean(axis=0)).max() < 0.6)\n"
        "lin = float(re.search('<linCoeff>(.*)</linCoeff>', open('setup.xml').read())[1])\n"
        "print(lin, s.astype(float).sum() * lin * c['dx'][0]**2)\n"
        "print(((f != 2) & (s > 0)).sum())\n");
    std::istringstream lines(printed);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line,
              "dx geometryFlag openingCenter openingIndex openingNormalizedQRatio openingRadius "
              "openingTangent stent");
    std::getline(lines, line);
    EXPECT_EQ(line, "uint16 uint16 True True");
    std::getline(lines, line);
    EXPECT_EQ(line, "True 1");
    std::getline(lines, line);
    EXPECT_EQ(line, "uint16 10 11 1.0");
    std::getline(lines, line);
    EXPECT_EQ(line, "True True");
    double linear = 0.0, integral = 0.0;
    int outside = -1;
    lines >> linear >> integral >> outside;
    EXPECT_NEAR(linear, 0.4, 1e-9);
    EXPECT_NEAR(integral / (fluid.viscosity * resistance_integral(tube.nodes)), 1.0, 1e-3);
    EXPECT_EQ(outside, 0);
}

TEST_F(LatticeExport, NotesSayWhatHemoFlowMakesOfTheQuadraticPart)
{
    const TubeLattice tube;
    LatticeExportOptions options;
    options.targets = {LatticeTarget::hemoflow};
    const std::vector<std::string> notes =
        write_lattice(folder(), tube.nodes, tube.vessel, Fluid{1055.0, 3.4e-3}, options);
    EXPECT_THAT(notes, ::testing::Contains(::testing::HasSubstr(
                           "hemoflow takes the quadratic part in one ratio to the linear one")));
}

TEST_F(LatticeExport, HemoFlowWantsOpeningsOnTheFacesOfTheBox)
{
    TubeLattice tube;
    TriangleMesh turned = tube.vessel.wall;
    for (Vec3& point : turned.points)
        point = Eigen::AngleAxisd(0.3, Vec3::UnitX()) * point;
    const Vessel vessel = make_vessel(turned, tube.vessel.unit);
    PorousField empty;
    empty.grid = {Vec3::Zero(), 0.1e-3, {1, 1, 1}};
    tube.nodes = make_lattice_nodes(empty, vessel, 0);
    try {
        write_hemoflow(folder(), tube.nodes, vessel, Fluid{}, {});
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(),
                    ::testing::HasSubstr("hemoflow wants openings flat on the faces"));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("turned by 17 degrees"));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("state openings = \"extended\""));
    }
}

// An opening that is flat, but not where the vessel ends along its axis: HemoFlow's box would leave
// fluid out.
TEST_F(LatticeExport, HemoFlowWantsNoFluidBeyondAnOpening)
{
    TubeLattice tube;
    const auto fluid = static_cast<std::uint8_t>(NodeType::fluid);
    tube.nodes.type[tube.nodes.grid.index(3, 3, 0)] = fluid;
    try {
        write_hemoflow(folder(), tube.nodes, tube.vessel, Fluid{}, {});
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("along z fluid reaches from node 0 to"));
    }
}

// Ten thousand times the mean resistance in one node is more than a weight of 65535 thousandths.
TEST_F(LatticeExport, HemoFlowRefusesWeightsThatItCannotHold)
{
    TubeLattice tube(0.4);
    tube.nodes.darcy[0] = 1e4 * tube.nodes.darcy[100];
    try {
        write_hemoflow(folder(), tube.nodes, tube.vessel, Fluid{1055.0, 3.4e-3}, {});
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("hemoflow holds weights up to 65535"));
    }
}

// a = nu D dt: at its largest w a dt / (rho dx) with w = 1/2, dt = 0.05 1e-4 / 0.3.
TEST_F(LatticeExport, HemoFlowTakesNoMoreThanItsExplicitForceBears)
{
    const TubeLattice tube(40000.0);
    try {
        write_hemoflow(folder(), tube.nodes, tube.vessel, Fluid{1055.0, 3.4e-3}, {});
        FAIL() << "nothing was thrown";
    } catch (const ConfigError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("explicit force diverges with a drag of"));
    }
}

}  // namespace
}  // namespace braidzone

#include "core/error.hpp"
#include "export/lattice_export.hpp"
#include "export/lattice_lbpm.hpp"
#include "support/lattices.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

namespace braidzone {
namespace {

using ::testing::HasSubstr;

const Fluid fluid{1055.0, 3.4e-3};

class LbpmExport : public ::testing::Test {
protected:
    std::string text_of(const std::string& file) const
    {
        std::ostringstream text;
        text << std::ifstream(folder.path() / file, std::ios::binary).rdbuf();
        return std::move(text).str();
    }

    void write(const LatticeNodes& nodes, const Vessel& vessel) const
    {
        write_lbpm(folder.path(), nodes, vessel, propose_units(nodes, fluid, {}), {});
    }

    std::string refusal(const LatticeNodes& nodes, const Vessel& vessel) const
    {
        try {
            write(nodes, vessel);
        } catch (const ConfigError& error) {
            return error.what();
        }
        return "nothing was thrown";
    }

    test::TemporaryFolder folder;
};

// The same lattice as NumPy has it, cut to the box of lattice.json: eps / (K dx^2) is its Darcy
// coefficient node by node, in a slanted sheet that tells the axes apart.
TEST_F(LbpmExport, NumpyReadsWhatLbpmReads)
{
    const test::TubeLattice tube;
    LatticeExportOptions options;
    options.targets = {LatticeTarget::numpy, LatticeTarget::lbpm};
    write_lattice(folder.path(), tube.nodes, tube.vessel, fluid, options);
    std::ofstream(folder.path() / "script.py")
        << "import json, re, numpy as n\n"
           "c = json.load(open('lattice.json'))\n"
           "text = open('lbpm/input.db').read()\n"
           "N = [int(v) for v in re.search(r'\\bN = (.*)', text)[1].split(',')]\n"
           "box = c['targets']['lbpm']['box']\n"
           "print(N == box['dims'], N[2] == 61)\n"
           "read = lambda f, t: n.fromfile('lbpm/' + f, t).reshape(N, order='F')\n"
           "l = read('labels_u8.raw', 'u1')\n"
           "e, k = read('porosity_f64.raw', '<f8'), read('permeability_vox2_f64.raw', '<f8')\n"
           "s = tuple(slice(f, f + d) for f, d in zip(box['first'], N))\n"
           "t, d = n.load('numpy/cell_type.npy')[s], n.load('numpy/darcy.npy')[s]\n"
           "print(((l > 0) == (t >= 2)).all(), ((l == 2) == (d > 0)).all(), (l == 2).sum() > "
           "1000)\n"
           "print((e[l == 2] == 0.999999).all(), (e[l != 2] == 1).all(), (k > 0).all())\n"
           "r = (e / k / c['spacing_m']**2)[l == 2] / d[l == 2]\n"
           "print(abs(r - 1).max() < 1e-6)\n"
           "print((l[:, :, 0] > 0).sum() > 600, (l[:, :, -1] > 0).sum() > 600)\n";
    const std::string command =
        fmt::format("cd '{}' && /usr/bin/python3 script.py > printed", folder.path().string());
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(text_of("printed"), "True True\nTrue True True\nTrue True True\nTrue\nTrue True\n");
}

// dt = 0.05 1e-4 / 0.6 = 8.3333e-6 s, nu_lu = 3.2227e-6 dt / 1e-8 = 2.68562e-3, tau = 0.508056865.
// Between the openings lie 60 spacings, the radius is 15 (a polygon's: 14.99): the densities differ
// by 3 8 nu_lu 0.025 60 / 14.99^2 = 4.302e-4.
TEST_F(LbpmExport, InputDrivesFlowFromTheInlet)
{
    const test::TubeLattice first(400.0, 0), second(400.0, 1);
    for (const test::TubeLattice* tube : {&first, &second}) {
        write(tube->nodes, tube->vessel);
        const std::string input = text_of("input.db");
        EXPECT_THAT(input, HasSubstr("tau = 0.508056"));
        EXPECT_THAT(input, HasSubstr("voxel_length = 100\n"));
        EXPECT_THAT(input, HasSubstr("BC = 3\n"));
        EXPECT_THAT(input, HasSubstr("collision = \"MRT\"\n"));
        EXPECT_THAT(input, HasSubstr("velocities times 12 are in m/s"));
        const int inlet = tube->nodes.openings.front().opening;
        const bool is_lower =
            tube->vessel.openings[static_cast<std::size_t>(inlet)].normal.z() < 0.0;
        const auto number = [&](const std::string& key) {
            return std::stod(input.substr(input.find(key + " = ") + key.size() + 3));
        };
        const double difference = number("din") - number("dout");
        EXPECT_NEAR(std::abs(difference), 4.302e-4, 2e-6);
        EXPECT_EQ(difference > 0.0, is_lower);
    }
}

// x and z of the tube change places.
TEST_F(LbpmExport, RefusesOpeningsOnOtherFaces)
{
    TriangleMesh along_x = test::tube(1.5e-3, 6e-3, 48, 12);
    for (Vec3& point : along_x.points)
        point = Vec3(point.z(), point.x(), point.y());
    const Vessel vessel = make_vessel(along_x, LengthUnit{});
    PorousField empty;
    empty.grid = {Vec3::Zero(), 0.1e-3, {1, 1, 1}};
    const std::string message = refusal(make_lattice_nodes(empty, vessel, 0), vessel);
    EXPECT_THAT(message, HasSubstr("lbpm drives flow along z"));
    EXPECT_THAT(message, HasSubstr("face across x; state openings = \"extended_z\""));
}

// 0.142887 (sqrt(1.5e9) + sqrt(2.5e9)) / ((6144 + 7168) / 2) = 0.142887 88729.8 / 6656 = 1.90480.
TEST(LbpmQuadraticRatio, MatchesHandCalculation)
{
    LatticeNodes nodes = test::asymmetric_lattice();
    EXPECT_NEAR(lbpm_quadratic_ratio(nodes), 1.90480, 1e-5);
    nodes.forchheimer = {0.0, 0.0};
    EXPECT_EQ(lbpm_quadratic_ratio(nodes), std::numeric_limits<double>::infinity());
    nodes.darcy = {0.0, 0.0};
    EXPECT_EQ(lbpm_quadratic_ratio(nodes), 0.0);
}

TEST_F(LbpmExport, NotesSayHowLargeItsOwnQuadraticPartIs)
{
    const test::TubeLattice tube;
    LatticeExportOptions options;
    options.targets = {LatticeTarget::lbpm};
    const std::vector<std::string> notes =
        write_lattice(folder.path(), tube.nodes, tube.vessel, fluid, options);
    EXPECT_THAT(notes, ::testing::Contains(HasSubstr(
                           "lbpm takes no quadratic part of the resistance but has one of its "
                           "own, ")));
}

}  // namespace
}  // namespace braidzone

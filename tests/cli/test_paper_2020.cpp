// cases/paper_2020/reproduce against Zavodszky et al. 2020, doi 10.1002/cnm.3340.

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace braidzone {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::vector<std::string> lattices = {"crossings", "paper-2020",
                                           "paper-2020, hubs on the centerline"};

class Paper2020 : public testing::Test {
protected:
    Json reproduce(const std::string& part)
    {
        const fs::path script = fs::path(BRAIDZONE_SOURCE_DIR) / "cases/paper_2020/reproduce";
        const fs::path output = folder_.path() / part;
        const std::string command =
            "BRAIDZONE='" BRAIDZONE_PROGRAM "' PYTHONDONTWRITEBYTECODE=1 '" + script.string() +
            "' --no-figures --only " + part + " --output '" + output.string() + "' > '" +
            (folder_.path() / "text").string() + "'";
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
        std::ifstream file(output / "comparison.json");
        EXPECT_TRUE(file.is_open());
        return Json::parse(file)[part];
    }

    test::TemporaryFolder folder_;
};

// The closed form has the artery's nominal diameter, the simulation its facets: 0.25 mm on a radius
// of 0.75 mm leave 0.01 mm, which is 1 % of the length at the steepest place of the curve.
// Table 1's ratios have two digits.
TEST_F(Paper2020, ForceFreeLengthsFollowFigure2AndTable1)
{
    const Json table = reproduce("table_1");
    ASSERT_EQ(table["lengths"].size(), 24u);
    for (const Json& point : table["lengths"]) {
        const double expected = point["closed_form"];
        EXPECT_NEAR(point["simulated"].get<double>(), expected, 0.01 * expected) << point;
    }
    const std::map<std::string, double> ratios = {{"2.5", 0.54}, {"3", 0.48},   {"3.5", 0.44},
                                                  {"4", 0.40},   {"4.5", 0.37}, {"5", 0.35}};
    for (const auto& [nominal, ratio] : ratios) {
        EXPECT_NEAR(table["braid_ratio"].at(nominal).get<double>(), ratio, 0.005) << nominal;
    }
}

// Lengths to the paper's rounding; trends as its section 3 states them: push makes the surface
// "approximately twice" as dense and leaves the load alone, 5 mm "does not lead to higher surface
// density" but "approximately doubles the load" (86.1 / 36.9 = 2.3 in the table). Half of 1, where
// it says twice, and 0.2, where it sees no substantial change, are taken as its "approximately".
TEST_F(Paper2020, FourScenariosShowTheTrendsOfTable3)
{
    const Json table = reproduce("table_3");
    for (const std::string& lattice : lattices) {
        SCOPED_TRACE(lattice);
        const Json& result = table.at(lattice);
        const auto value = [&](const char* scenario, const char* quantity) {
            return result.at(scenario).at(quantity).get<double>();
        };
        for (const auto& [scenario, length] : table["paper"]["implanted_length"].items()) {
            EXPECT_NEAR(value(scenario.c_str(), "implanted_length"), length.get<double>(), 0.5);
            EXPECT_EQ(value(scenario.c_str(), "inverted_rhombi"), 0.0);
            EXPECT_EQ(value(scenario.c_str(), "nodes_outside_vessel"), 0.0);
        }
        for (const std::string device : {"4mm", "5mm"}) {
            const std::string pushed = device + "_push";
            const auto push_ratio = [&](const char* quantity, double offset) {
                return (offset + value(pushed.c_str(), quantity)) /
                       (offset + value(device.c_str(), quantity));
            };
            EXPECT_NEAR(push_ratio("implanted_length", 0.0), 0.75, 0.05) << device;
            EXPECT_NEAR(push_ratio("density_increase", 100.0), 2.0, 0.5) << device;
            EXPECT_NEAR(push_ratio("contact_pressure", 0.0), 1.0, 0.2) << device;
            EXPECT_GT(push_ratio("expansion", 0.0), 1.01) << device;
        }
        EXPECT_LE(value("5mm", "density_increase"), value("4mm", "density_increase"));
        EXPECT_LE(value("5mm_push", "density_increase"), value("4mm_push", "density_increase"));
        EXPECT_NEAR(value("5mm", "contact_pressure") / value("4mm", "contact_pressure"), 2.3, 0.5);
    }
}

TEST_F(Paper2020, TortuousAndGiantCasesStayInsideTheVessel)
{
    const Json figure = reproduce("figure_10");
    for (const char* name : {"tortuous", "giant"}) {
        EXPECT_EQ(figure[name]["inverted_rhombi"], 0) << name;
        EXPECT_EQ(figure[name]["nodes_outside_vessel"], 0) << name;
    }
}

}  // namespace
}  // namespace braidzone

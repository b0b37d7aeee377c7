#include "core/error.hpp"
#include "core/toml_reader.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace braidzone {
namespace {

class TomlReader : public testing::Test {
protected:
    TomlTable read(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        return TomlTable::read_file(folder_.write("case.toml", text), overrides);
    }

    /// The message of the ConfigError that the action throws, with the path shortened to the name.
    std::string message(const std::function<void()>& action) const
    {
        try {
            action();
        } catch (const ConfigError& error) {
            std::string text = error.what();
            const std::string prefix = folder_.path().string() + "/";
            for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
                text.erase(at, prefix.size());
            }
            return text;
        }
        return "nothing was thrown";
    }

    test::TemporaryFolder folder_;
};

constexpr auto device = R"([device]
name = "pipeline-flex"
num_wires = 48
braid_ratio = 0.4
any_size = true
diameter = "4 mm"
sizes = ["3 mm", "3.5 mm"]
[vessel]
from = ["1 mm", "-2 mm", "0.3 cm"]
[[export]]
format = "vtk"
[[export]]
format = "openvdb"
)";

TEST_F(TomlReader, GivesEachValueInItsType)
{
    const TomlTable root = read(device);
    const TomlTable table = root.table("device");
    EXPECT_EQ(table.text("name"), "pipeline-flex");
    EXPECT_EQ(table.integer("num_wires"), 48);
    EXPECT_EQ(table.number("num_wires"), 48.0);
    EXPECT_EQ(table.number("braid_ratio"), 0.4);
    EXPECT_TRUE(table.boolean("any_size"));
    EXPECT_EQ(table.quantity("diameter", Dimension::length), 4e-3);
    EXPECT_EQ(table.quantities("sizes", Dimension::length), (std::vector<double>{3e-3, 3.5e-3}));
    EXPECT_EQ(table.texts("sizes"), (std::vector<std::string>{"3 mm", "3.5 mm"}));
    EXPECT_EQ(root.table("vessel").point("from"), Vec3(1e-3, -2e-3, 3e-3));
    ASSERT_EQ(root.tables("export").size(), 2u);
    EXPECT_EQ(root.tables("export")[1].text("format"), "openvdb");
}

TEST_F(TomlReader, GivesTheFallbackForAMissingKeyOnly)
{
    const TomlTable table = read(device).table("device");
    EXPECT_EQ(table.text_or("title", "none"), "none");
    EXPECT_EQ(table.text_or("name", "none"), "pipeline-flex");
    EXPECT_EQ(table.number_or("ratio", 1.5), 1.5);
    EXPECT_EQ(table.integer_or("wires", 64), 64);
    EXPECT_TRUE(table.boolean_or("repair", true));
    EXPECT_EQ(table.quantity_or("length", Dimension::length, 0.02), 0.02);
    EXPECT_THROW(table.quantity_or("num_wires", Dimension::length, 0.02), ConfigError);
    EXPECT_FALSE(table.has("title"));
    EXPECT_TRUE(table.is_array("sizes"));
    EXPECT_FALSE(table.is_array("diameter"));
    EXPECT_TRUE(table.tables("push_pull").empty());
    EXPECT_EQ(table.table_or_empty("material").text_or("name", "steel"), "steel");
}

TEST_F(TomlReader, ListsKeysInTheOrderOfTheFile)
{
    const TomlTable table = read("[fit]\nzeta = 1\nalpha = 2\nmu = 3\n").table("fit");
    EXPECT_EQ(table.keys(), (std::vector<std::string>{"zeta", "alpha", "mu"}));
}

TEST_F(TomlReader, NamesThePlaceOfAValue)
{
    const TomlTable root = read(device);
    EXPECT_EQ(root.table("device").where("diameter"),
              folder_.path().string() + "/case.toml:6: device.diameter");
    EXPECT_EQ(root.tables("export")[1].where("format"),
              folder_.path().string() + "/case.toml:13: export.format");
    EXPECT_EQ(root.folder(), folder_.path());
}

TEST_F(TomlReader, RefusesAnotherTypeAndSaysWhatItFound)
{
    const TomlTable root = read(device);
    const TomlTable table = root.table("device");
    EXPECT_EQ(message([&] { table.text("num_wires"); }),
              "case.toml:3: device.num_wires = 48 is an integer; expected is a string");
    EXPECT_EQ(message([&] { table.integer("braid_ratio"); }),
              "case.toml:4: device.braid_ratio = 0.4 is a number; expected is an integer");
    EXPECT_EQ(message([&] { table.number("name"); }),
              "case.toml:2: device.name = \"pipeline-flex\" is a string; expected is a number");
    EXPECT_EQ(message([&] { table.boolean("sizes"); }),
              "case.toml:7: device.sizes is an array; expected is true or false");
    EXPECT_EQ(message([&] { table.texts("name"); }),
              "case.toml:2: device.name = \"pipeline-flex\" is a string; expected is an array of "
              "strings");
    EXPECT_EQ(message([&] { root.table("device").table("name"); }),
              "case.toml:2: device.name = \"pipeline-flex\" is a string; expected is a table");
    EXPECT_EQ(message([&] { root.tables("device"); }),
              "case.toml:1: device is a table; expected is an array of tables [[device]]");
    EXPECT_EQ(message([&] { table.tables("sizes"); }),
              "case.toml:7: device.sizes = \"3 mm\" is a string; expected is an array of tables "
              "[[device.sizes]]");
}

TEST_F(TomlReader, RefusesABareNumberWhereAUnitIsNeeded)
{
    const TomlTable table = read(device).table("device");
    EXPECT_EQ(
        message([&] { table.quantity("num_wires", Dimension::length); }),
        "case.toml:3: device.num_wires = 48 is an integer; expected is a string with a number "
        "and a unit of length: m, cm, mm, um, in");
    EXPECT_EQ(message([&] { table.quantity("diameter", Dimension::time); }),
              "case.toml:6: device.diameter = \"4 mm\" has the unit \"mm\"; expected is a number "
              "with a unit of time: s, ms");
    EXPECT_THROW(read("[a]\nx = [1, 2]\n").table("a").quantities("x", Dimension::length),
                 ConfigError);
}

TEST_F(TomlReader, RefusesAPointThatHasNotThreeLengths)
{
    const TomlTable table = read("[a]\np = [\"1 mm\", \"2 mm\"]\nq = [1, 2, 3]\n").table("a");
    EXPECT_EQ(message([&] { table.point("p"); }),
              R"(case.toml:2: a.p is an array; expected is a point: ["x mm", "y mm", "z mm"])");
    EXPECT_THROW(table.point("q"), ConfigError);
}

TEST_F(TomlReader, ReadsArraysOfNumbers)
{
    const TomlTable table = read("[a]\nx = [1, 2.5]\ny = [1, \"2\"]\n").table("a");
    EXPECT_EQ(table.numbers("x"), (std::vector<double>{1.0, 2.5}));
    EXPECT_EQ(message([&] { table.numbers("y"); }),
              "case.toml:3: a.y = \"2\" is a string; expected is an array of finite numbers");
}

TEST_F(TomlReader, RefusesNumbersThatAreNotFinite)
{
    const TomlTable table = read("[a]\nx = nan\ny = -inf\nz = [nan]\n").table("a");
    EXPECT_THROW(table.numbers("z"), ConfigError);
    EXPECT_THROW(table.number("x"), ConfigError);
    EXPECT_THROW(table.number("y"), ConfigError);
}

TEST_F(TomlReader, NamesAMissingKeyAndItsSection)
{
    const TomlTable root = read(device);
    EXPECT_EQ(
        message([&] { root.table("device").quantity("length", Dimension::length); }),
        "case.toml:1: device.length is missing; expected is a length with its unit: m, cm, mm, "
        "um, in");
    EXPECT_EQ(message([&] { root.table("fluid"); }),
              "case.toml: fluid is missing; expected is a section [fluid]");
}

TEST_F(TomlReader, RefusesKeysThatNobodyAskedFor)
{
    const TomlTable root = read("[device]\nname = \"a\"\ndiametre = \"4 mm\"\n");
    const TomlTable table = root.table("device");
    table.text("name");
    table.has("diameter");
    EXPECT_EQ(message([&] { root.finish(); }),
              "case.toml:3: device.diametre: unknown key; did you mean \"diameter\"?");

    const TomlTable other = read("[devise]\nname = \"a\"\n");
    other.table_or_empty("device");
    EXPECT_EQ(message([&] { other.finish(); }),
              "case.toml:1: devise: unknown key; did you mean \"device\"?");

    const TomlTable exports = read("[[export]]\nformat = \"vtk\"\nfolder = \"x\"\n");
    exports.tables("export")[0].text("format");
    EXPECT_EQ(message([&] { exports.finish(); }),
              "case.toml:3: export.folder: unknown key; known are format");
}

TEST_F(TomlReader, AcceptsADocumentWhoseKeysWereAllAskedFor)
{
    const TomlTable root = read("[device]\nname = \"a\"\n");
    root.table("device").text("name");
    EXPECT_NO_THROW(root.finish());
}

TEST_F(TomlReader, AppliesOverridesBeforeAnyValueIsRead)
{
    const TomlTable root =
        read(device, {"device.diameter=3.5 mm", "device.num_wires=64", "device.any_size=false",
                      "vessel.from=[\"0 m\",\"0 m\",\"1 m\"]", "fluid.density=\"1000 kg/m^3\"",
                      "device.name="});
    const TomlTable table = root.table("device");
    EXPECT_EQ(table.quantity("diameter", Dimension::length), 3.5e-3);
    EXPECT_EQ(table.integer("num_wires"), 64);
    EXPECT_FALSE(table.boolean("any_size"));
    EXPECT_EQ(table.text("name"), "");
    EXPECT_EQ(root.table("vessel").point("from"), Vec3(0, 0, 1));
    EXPECT_EQ(root.table("fluid").quantity("density", Dimension::density), 1000.0);
    EXPECT_NE(root.document_text().find("3.5 mm"), std::string::npos);
}

TEST_F(TomlReader, SaysThatAWrongValueCameFromAnOverride)
{
    const TomlTable root = read(device, {"device.diameter=4"});
    EXPECT_EQ(message([&] { root.table("device").quantity("diameter", Dimension::length); }),
              "--set device.diameter = 4 is an integer; expected is a string with a number and a "
              "unit of length: m, cm, mm, um, in");
}

TEST_F(TomlReader, RefusesMalformedOverrides)
{
    EXPECT_EQ(message([&] { read(device, {"device.diameter"}); }),
              "--set \"device.diameter\" is not of the form section.key=value");
    EXPECT_EQ(message([&] { read(device, {"device..x=1"}); }),
              "--set \"device..x=1\" is not of the form section.key=value");
    EXPECT_EQ(message([&] { read(device, {"export.format=vtk"}); }),
              "--set export.format=vtk: export is no section with keys that can be set");
}

TEST_F(TomlReader, DoesNotLetAnOverrideAddFurtherKeys)
{
    const TomlTable root = read(device, {"device.name=1\nother = 2"});
    EXPECT_EQ(root.table("device").text("name"), "1\nother = 2");
}

TEST_F(TomlReader, RefusesWhatIsNoToml)
{
    EXPECT_NE(message([&] { read("[device]\nname = \n"); }).find("case.toml:2: not valid TOML: "),
              std::string::npos);
    EXPECT_NE(message([&] { read("a = 1\na = 2\n"); }).find("case.toml:2: not valid TOML: "),
              std::string::npos);
    EXPECT_THROW(read("a = \"\xff\"\n"), ConfigError);
}

TEST_F(TomlReader, RefusesAFileThatCannotBeRead)
{
    EXPECT_THROW(TomlTable::read_file(folder_.path() / "absent.toml"), IoError);
    EXPECT_THROW(TomlTable::read_file(folder_.path()), IoError);
}

}  // namespace
}  // namespace braidzone

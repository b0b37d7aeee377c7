#include "core/error.hpp"
#include "core/surface_io.hpp"
#include "discrepancy/measured_surface.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace braidzone {
namespace {

using testing::HasSubstr;

template <typename Thrown, typename Read>
std::string message_of(const Read& read)
{
    try {
        read();
    } catch (const Thrown& error) {
        return error.what();
    }
    return "nothing was thrown";
}

const LengthUnit mm;

}  // namespace

TEST(ReadMeasuredSurface, TakesPointsFromCsv)
{
    const test::TemporaryFolder folder;
    const auto points =
        read_measured_surface(folder.write("p.csv", "x_cm,y_cm,z_cm\n1, 2,3\n-1,0,1e-1\n"), {});
    ASSERT_EQ(points.size(), 2u);
    EXPECT_LT((points[0] - Vec3(0.01, 0.02, 0.03)).norm(), 1e-15);
    EXPECT_LT((points[1] - Vec3(-0.01, 0.0, 0.001)).norm(), 1e-15);
}

TEST(ReadMeasuredSurface, TakesPointsFromXyz)
{
    const test::TemporaryFolder folder;
    const auto points =
        read_measured_surface(folder.write("p.XYZ", "# scan\n1 2 3\n\n4\t5 6\n"), mm);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_LT((points[1] - Vec3(4e-3, 5e-3, 6e-3)).norm(), 1e-15);
}

TEST(ReadMeasuredSurface, TakesThePointsOfATriangulatedSurface)
{
    const test::TemporaryFolder folder;
    write_stl(folder.path() / "box.stl", test::unit_box(), LengthUnit{"m", 1.0});
    EXPECT_EQ(read_measured_surface(folder.path() / "box.stl", LengthUnit{"m", 1.0}).size(), 8u);
}

TEST(ReadMeasuredSurface, RefusesWithThePlaceAndWhatIsExpected)
{
    const test::TemporaryFolder folder;
    const auto refusal = [&](const char* name, const char* text) {
        return message_of<InputError>(
            [&] { read_measured_surface(folder.write(name, text), std::nullopt); });
    };
    EXPECT_THAT(refusal("a.csv", "x,y,z\n1,2,3\n"),
                HasSubstr("a.csv:1: \"x,y,z\" is not the header of measured points; expected is "
                          "x_mm,y_mm,z_mm"));
    EXPECT_THAT(refusal("b.csv", "x_mm,y_mm,z_mm\n1,2\n"),
                HasSubstr("b.csv:2: has 2 values; a point has three coordinates"));
    EXPECT_THAT(refusal("c.csv", "x_mm,y_mm,z_mm\n1,2,3\n1,nan,3\n"),
                HasSubstr("c.csv:3: \"nan\" is not a coordinate; a finite number is expected"));
    EXPECT_THAT(message_of<ConfigError>(
                    [&] { read_measured_surface(folder.write("d.xyz", "1 2 3\n"), std::nullopt); }),
                HasSubstr("does not state the unit of its coordinates; give --length-unit"));
    EXPECT_THAT(message_of<ConfigError>([&] {
                    read_measured_surface(folder.write("e.csv", "x_m,y_m,z_m\n1,2,3\n"), mm);
                }),
                HasSubstr("--length-unit mm stands beside the header of"));
    EXPECT_THAT(message_of<IoError>([&] { read_measured_surface(folder.path() / "no.csv", mm); }),
                HasSubstr("no.csv cannot be read"));
    EXPECT_THROW(read_measured_surface(folder.write("f.txt", "1 2 3\n"), mm), InputError);
}

}  // namespace braidzone

#include "export/foam_format.hpp"
#include "export/foam_per_cell.hpp"
#include "support/foam_box.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace braidzone {
namespace {

/// Resistance on every cell, normals in all directions.
CellResistance turning_resistance(int num_cells, double tangential_ratio)
{
    CellResistance resistance;
    resistance.tangential_ratio = {tangential_ratio, tangential_ratio};
    for (int i = 0; i < num_cells; ++i) {
        resistance.cells.push_back(i);
        resistance.darcy.push_back(1e8 * (1 + i));
        resistance.forchheimer.push_back(3e3);
        resistance.normal.push_back(
            Vec3(std::cos(0.7 * i), std::sin(1.3 * i), std::sin(2.1 * i + 0.3)).normalized());
    }
    return resistance;
}

// Added up, the directions are the tensor D_n (r I + (1 - r) n n^T), negative coefficients or not.
TEST(DirectedFields, AddUpToTheTensor)
{
    for (const double ratio : {0.0, 0.3, 5.0}) {
        const CellResistance resistance = turning_resistance(20, ratio);
        const auto fields = directed_fields(resistance);
        ASSERT_EQ(fields.size(), 6U);
        for (std::size_t i = 0; i < resistance.cells.size(); ++i) {
            Mat3 sum = Mat3::Zero();
            for (const FoamDirectedField& field : fields)
                sum += field.coefficient[i] * field.e1 * field.e1.transpose();
            const Vec3& n = resistance.normal[i];
            const Mat3 expected = resistance.darcy[i] *
                                  (ratio * Mat3::Identity() + (1.0 - ratio) * n * n.transpose());
            EXPECT_LT((sum - expected).norm(), 1e-12 * expected.norm());
        }
    }
}

TEST(DirectedFields, IsotropicResistanceNeedsThree)
{
    const CellResistance resistance = turning_resistance(5, 1.0);
    const auto fields = directed_fields(resistance);
    ASSERT_EQ(fields.size(), 3U);
    for (const FoamDirectedField& field : fields)
        EXPECT_EQ(field.coefficient, resistance.darcy);
}

TEST(DirectedFields, NoneWithoutLinearResistance)
{
    CellResistance resistance = turning_resistance(5, 1.0);
    for (double& darcy : resistance.darcy)
        darcy = 0.0;
    EXPECT_TRUE(directed_fields(resistance).empty());
    EXPECT_EQ(directed_field_functions({}), "");
}

// OpenFOAM registers both a source and a field under their names; equal ones hide the field.
TEST(PerCellSources, AreNotCalledAsTheirFields)
{
    for (const FoamPorousSource& source :
         per_cell_sources(directed_fields(turning_resistance(5, 0.3)))) {
        EXPECT_NE(source.name, source.viscosity_field);
        EXPECT_EQ(source.cell_zone, per_cell_zone);
        EXPECT_EQ(source.darcy, Vec3::UnitX());
        EXPECT_EQ(source.forchheimer, Vec3::Zero());
    }
}

// nu c by hand: 3e-6 m^2/s times 2e8 1/m^2 in the second resisting cell, which is cell 2.
TEST(WriteDirectedFields, HoldsViscosityTimesCoefficient)
{
    const test::TemporaryFolder folder;
    const FoamMesh mesh = test::foam_box({4, 1, 1}, 1e-4);
    CellResistance resistance = turning_resistance(2, 1.0);
    resistance.cells = {0, 2};
    const auto files =
        write_directed_fields(folder.path(), directed_fields(resistance), resistance, mesh, 3e-6);
    ASSERT_EQ(files.size(), 3U);
    FoamReader reader(folder.path() / files[1]);
    EXPECT_EQ(reader.header().class_name, "volScalarField");
    while (reader.word() != "internalField")
        reader.entry();
    EXPECT_EQ(reader.word(), "nonuniform");
    EXPECT_EQ(reader.word(), "List<scalar>");
    const std::vector<double> values = reader.scalars();
    ASSERT_EQ(values.size(), 4U);
    EXPECT_DOUBLE_EQ(values[0], 300.0);
    EXPECT_EQ(values[1], 0.0);
    EXPECT_DOUBLE_EQ(values[2], 600.0);

    const auto any = directed_field_files(folder.path());
    EXPECT_EQ(any.size(), 6U);
    for (const auto& file : files)
        EXPECT_NE(std::find(any.begin(), any.end(), file), any.end()) << file;
}

}  // namespace
}  // namespace braidzone

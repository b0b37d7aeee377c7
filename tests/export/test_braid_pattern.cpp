#include "export/braid_pattern.hpp"
#include "export/wire_path.hpp"
#include "support/devices.hpp"

#include <gtest/gtest.h>

#include <string>

namespace braidzone {
namespace {

/// Where a wire lies at its crossings, from the distal end: "o" outside, "i" inside.
std::string course(const BraidPattern& pattern, const BraidLattice& lattice, Wire wire)
{
    std::string text;
    for (int ring = 0; ring < lattice.num_rings; ++ring) {
        const bool right =
            right_handed_is_outside(pattern, lattice, ring, column_of_wire(lattice, wire, ring));
        text += right == (wire.family == WireFamily::right_handed) ? 'o' : 'i';
    }
    return text;
}

/// "oi", "ooii" or "oooiii", over and over.
std::string repeated(int over, int length)
{
    const auto count = static_cast<std::size_t>(over);
    std::string text;
    while (static_cast<int>(text.size()) < length)
        text += std::string(count, 'o') + std::string(count, 'i');
    return text;
}

// Every wire of both families has the same course, only shifted: also across the seam of columns.
TEST(BraidPattern, EveryWireGoesOverAndUnderInTheSameRhythm)
{
    const BraidLattice lattice = make_lattice(test::pipeline_4x20());
    for (const int over : {1, 2, 3}) {
        const std::string rhythm = repeated(over, lattice.num_rings + 2 * over);
        for (const Wire wire : wires_of(lattice)) {
            EXPECT_NE(rhythm.find(course({over}, lattice, wire)), std::string::npos)
                << over << ", wire " << wire.number;
        }
    }
}

// Half of the crossings of two rings in a row, so that neither family is the outer one.
TEST(BraidPattern, FavoursNoFamily)
{
    const BraidLattice lattice = make_lattice(test::pipeline_4x20());
    for (const int over : {1, 2, 3}) {
        for (int ring = 0; ring + 1 < lattice.num_rings; ++ring) {
            int outside = 0;
            for (int column = 0; column < lattice.nodes_per_ring; ++column) {
                outside += right_handed_is_outside({over}, lattice, ring, column);
                outside += right_handed_is_outside({over}, lattice, ring + 1, column);
            }
            EXPECT_EQ(outside, lattice.nodes_per_ring);
        }
    }
}

// 24 crossings a ring make repeats of 1, 2 and 3, 25 only of 1.
TEST(BraidPattern, ClosesAroundWholeRepeatsOnly)
{
    for (const int over : {1, 2, 3}) {
        EXPECT_TRUE(closes_around({over}, 24));
        EXPECT_EQ(closes_around({over}, 25), over == 1);
    }
}

TEST(BraidPattern, HasANameForEachNumber)
{
    EXPECT_EQ(braid_pattern_names(),
              (std::vector<std::string>{"1-over-1", "2-over-2", "3-over-3"}));
}

}  // namespace
}  // namespace braidzone

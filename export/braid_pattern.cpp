#include "export/braid_pattern.hpp"

#include <cassert>

namespace braidzone {

std::vector<std::string> braid_pattern_names()
{
    return {"1-over-1", "2-over-2", "3-over-3"};
}

bool closes_around(const BraidPattern& pattern, int nodes_per_ring)
{
    // 2 n half node spacings, in bands of over and under.
    return nodes_per_ring % pattern.over == 0;
}

bool right_handed_is_outside(const BraidPattern& pattern, const BraidLattice& lattice, int ring,
                             int column)
{
    assert(closes_around(pattern, lattice.nodes_per_ring));
    const int half_turns = 2 * lattice.nodes_per_ring;
    // Along a wire this goes by one from crossing to crossing, down or up with its family.
    const int place = ((2 * column + ring) % half_turns + half_turns) % half_turns;
    return place / pattern.over % 2 == 0;
}

}  // namespace braidzone

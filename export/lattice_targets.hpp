#pragma once

#include <string>
#include <vector>

namespace braidzone {

/// What a lattice is written for.
enum class LatticeTarget { numpy, openlb, palabos, walberla, hemoflow, lbpm };

/// What a program takes of a lattice.
struct TargetTraits {
    LatticeTarget target;
    const char* name;             ///< in the case file, and its folder's
    bool has_linear;              ///< takes the linear resistance
    const char* quadratic_limit;  ///< what it takes of the quadratic one; null: all
    bool has_normal;              ///< takes a tensor
    /// Value of the key `openings` that lays the openings on the faces of the box as it wants them;
    /// null: it takes any.
    const char* flat_openings;
    double bytes_a_node;  ///< of its files on the disk, at most
};

const TargetTraits& traits_of(LatticeTarget target);

/// Its name in the case file, and its folder.
std::string target_name(LatticeTarget target);

std::vector<LatticeTarget> all_lattice_targets();

/// Those that take any vessel: all but HemoFlow and LBPM, which want the openings on the faces of
/// the box.
std::vector<LatticeTarget> default_lattice_targets();

}  // namespace braidzone

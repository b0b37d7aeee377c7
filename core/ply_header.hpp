#pragma once

#include <istream>
#include <string>

namespace braidzone {

/// What is wrong with the header of a PLY file, for a surface; empty if nothing is.
///
/// CGAL's reader ends the program on a property without an element, and takes a coordinate whose
/// property is missing or misspelt for zero: so the header is looked at first. It must have a
/// format line, an element `vertex` with x, y and z of type float or double, and an element `face`
/// with a list of 32-bit integers `vertex_indices` or `vertex_index`; any other element or property
/// must have a name and a known type.
std::string ply_header_fault(std::istream& file);

}  // namespace braidzone

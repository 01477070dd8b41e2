#pragma once

#include <string>

#include "common/mesh/ply/ply_header.h"
#include "common/mesh/ply/ply_type.h"

namespace burnish {

/// Returns the value that a PLY type keeps of `value`: rounded, and within the type's range.
double kept_by(PlyType type, double value);

/// Returns a value's bytes in the body of a PLY file; in text the shortest decimal number that
/// reads back as the same value. Needs: the type keeps the value.
std::string ply_number(PlyType type, PlyEncoding encoding, double value);

}  // namespace burnish

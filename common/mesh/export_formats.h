#pragma once

#include <vector>

#include "common/mesh/mesh_format.h"

namespace burnish {

/// Returns the formats in which Burnish writes a scan that came in `own`, this one first if it is
/// one of them.
std::vector<MeshFormat> export_formats(MeshFormat own);

}  // namespace burnish

#pragma once

#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns whether some of the surface is flat: it bends by less than 1e-4 across a cell. A flat
/// piece has moves that take no energy in exact numbers; rounded numbers give them one, of either
/// sign. Scans are never flat because of their noise; designed parts and filled holes are.
bool has_flat_parts(const PreparedMesh& prepared);

}  // namespace burnish

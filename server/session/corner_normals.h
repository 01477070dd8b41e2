#pragma once

#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns the mean normal of the surface around each corner of the finest depth. The length is 1
/// where all of it faces one way, and 0 where two sides cancel.
std::vector<Vec3f> corner_normals(const PreparedMesh& prepared, const SparseGrid& grid);

}  // namespace burnish

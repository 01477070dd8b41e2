#pragma once

#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns for each corner of the finest depth the centre of its piece of surface: the mean of the
/// piece's cells by area. Cells that share a corner are of one piece. Units: cells.
std::vector<Vec3f> piece_centres(const PreparedMesh& prepared, const SparseGrid& grid);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <vector>

#include "common/edit/protect.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns 1 for each cell whose middle lies in the lasso. Unless it goes through, the surface of
/// the cell also faces the viewer; other surface before it does not count. Shapes: one per cell.
std::vector<uint8_t> cells_in_lasso(const PreparedMesh& prepared, const LassoRegion& lasso);

}  // namespace burnish

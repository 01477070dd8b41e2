#pragma once

#include <cstdint>

#include "common/base/status.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns the index of an active cell. Units: grid units. Fails: invalid_argument that names the
/// cell and the grid.
Result<int32_t> index_of_cell(const PreparedMesh& prepared, const Vec3i& cell);

}  // namespace burnish

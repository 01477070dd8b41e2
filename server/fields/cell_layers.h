#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns the index of an active cell of the finest depth, kNone if inactive or outside.
/// Cost: O(log cells).
int32_t find_cell(const PreparedMesh& prepared, const Vec3i& cell);

/// Returns the cells that the surface leads to from a cell in one step.
std::vector<int32_t> neighbours_of(const PreparedMesh& prepared, int32_t cell);

/// Returns for each cell how many steps along the surface it is from the nearest seed: 0 for the
/// seeds, `far` + 1 for all cells beyond `far`. A step leads through a passage.
/// Shapes: one entry per cell. Needs: far < 255.
std::vector<uint8_t> layers_from(const PreparedMesh& prepared, std::span<const int32_t> seeds,
                                 int far);

/// Returns 1 for each cell that the surface leads to from `seed`. Shapes: one entry per cell.
std::vector<uint8_t> cells_of_piece(const PreparedMesh& prepared, int32_t seed);

}  // namespace burnish

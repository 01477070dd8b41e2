#pragma once

#include <cstdint>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/prepare/grid_mesh.h"

namespace burnish {

/// The number of pieces, which are pairs of a cell and a triangle, by buckets of cells. A bucket is
/// a cube of cells: their keys begin with the same bits.
struct PieceCount {
  int shift = 0;                ///< of a cell's key to its bucket
  std::vector<uint64_t> start;  ///< of each bucket's pieces among all, and the end

  uint64_t total() const { return start.back(); }
};

/// The part of the phase "grid" that counting is.
inline constexpr double kCountedPart = 0.4;

/// Counts the pieces. Triangles without area, except for rounding, are in no cell. Cost: less than
/// a tenth of a preparation. It ends soon after `pieces_max`, because large triangles in a fine
/// grid have too many cells to count. Fails: resource_exhausted above pieces_max; cancelled.
Result<PieceCount> count_cell_pieces(const GridMesh& mesh, uint64_t pieces_max,
                                     const Progress& progress);

/// Bricks: consecutive buckets whose pieces are sorted together.
struct Bricks {
  std::vector<uint32_t> of_bucket;
  std::vector<uint64_t> start;  ///< of each brick's pieces among all, and the end

  size_t count() const { return start.size() - 1; }
};

/// Fills bricks with up to `pieces_max` pieces. A bucket with more is a brick by itself.
Bricks make_bricks(const PieceCount& count, uint64_t pieces_max);

}  // namespace burnish

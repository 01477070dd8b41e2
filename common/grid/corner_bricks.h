#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// Finds the corners of a grid's cells by bricks of 4×4×4. A brick's corners are the bits of one
/// word, so only a tenth of the keys needs sorting, and a corner's index is a count of bits.
class CornerBricks {
 public:
  /// Cells of one component in one brick, next to each other: [first, last).
  struct Run {
    int32_t first, last;
    uint8_t bricks;  ///< bricks of their corners: bit 0 their own, bits 1 to 7 those above it
  };

  /// Needs: cells strictly rising, alive and in place as long as this object.
  explicit CornerBricks(std::span<const GridKey> cells);

  std::span<const Run> runs() const { return runs_; }
  /// Strictly rising.
  std::vector<GridKey> corners() const;
  /// Writes the corners of a run's cells, by cell.
  void number(const Run& run, const GridKey* cells,
              std::array<int32_t, kCornersPerCell>* cell_corners) const;

 private:
  struct Brick {
    GridKey key;       // of the brick
    uint64_t corners;  // bits in Morton order
    int32_t first;     // of its corners in index_; rises like the corners from place to place
  };

  void find_runs(std::span<const GridKey> cells);
  void add_bricks(std::span<const GridKey> cells);
  void merge();
  void find_places();
  template <typename Visit>
  void for_each_corner(Visit&& visit) const;

  std::vector<Run> runs_;
  std::vector<Brick> bricks_;    // strictly rising
  std::vector<int32_t> places_;  // the first brick of each place, and the end
  std::vector<int32_t> index_;   // of every corner, by brick, then by bit
};

}  // namespace burnish

#pragma once

#include <cstdint>
#include <vector>

#include "common/base/groups.h"

namespace burnish {

struct Stencil;

/// Says where the columns of a stencil lie in a tile: first the corners of kRows rows, then the
/// other corners with an entry in one of the rows. A product first copies a vector's numbers there.
/// Then all are in the cache nearest to the processor, and indices have half the size.
struct RowTiles {
  static constexpr int32_t kRows = 512;
  static constexpr int32_t kWidthMax = 1 << 15;

  /// A row among the rows of its tile.
  struct Row {
    uint16_t place;   ///< place of its corner
    uint16_t groups;  ///< groups of Stencil::kRowPadding entries
  };

  std::vector<Row> row;
  std::vector<uint16_t> twice_local;  ///< two times the place of each Stencil::column
  Groups<int32_t, int64_t> halo;      ///< per tile, rising
  std::vector<uint8_t> is_wide;  ///< per tile: wider than kWidthMax, because irregular rows can be
                                 ///< long; such a tile has no halo and no places
  int32_t width_max = 0;         ///< of the other tiles, corners and halo

  int32_t count() const { return static_cast<int32_t>(is_wide.size()); }
};

/// Makes tiles of rows and finds their columns. No tile is wider than `width_max`.
RowTiles make_row_tiles(const Stencil& stencil, int32_t width_max = RowTiles::kWidthMax);

}  // namespace burnish

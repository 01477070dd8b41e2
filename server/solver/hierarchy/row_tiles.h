#pragma once

#include <cstdint>
#include <vector>

#include "common/base/groups.h"

namespace burnish {

struct Stencil;

/// Where the columns of a stencil stand in a tile: the corners of kRows rows, and behind them the
/// others that have an entry in one of the rows. A product that copies a vector's numbers there
/// first finds them all in the cache nearest to the processor, by indices of half the size.
struct RowTiles {
  static constexpr int32_t kRows = 512;
  static constexpr int32_t kWidthMax = 1 << 15;

  /// A row among those of its tile.
  struct Row {
    uint16_t place;   ///< of its corner
    uint16_t groups;  ///< of Stencil::kRowPadding entries
  };

  std::vector<Row> row;
  std::vector<uint16_t> twice_local;  ///< two times the place of each Stencil::column
  Groups<int32_t, int64_t> halo;      ///< of each tile, rising
  std::vector<uint8_t> is_wide;       ///< of each tile: wider than kWidthMax, and without halo or
                                      ///< places then, as irregular rows could have it
  int32_t width_max = 0;              ///< of the others, corners and halo

  int32_t count() const { return static_cast<int32_t>(is_wide.size()); }
};

/// Tiles of rows whose columns are there, none wider than `width_max`.
RowTiles make_row_tiles(const Stencil& stencil, int32_t width_max = RowTiles::kWidthMax);

}  // namespace burnish

#include "server/solver/hierarchy/row_tiles.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"
#include "common/base/sort_once.h"
#include "server/solver/hierarchy/stencil.h"

namespace burnish {

namespace {

struct Tile {
  int32_t begin, end;  // its rows, and their corners

  bool has(int32_t corner) const { return corner >= begin && corner < end; }
  int32_t rows() const { return end - begin; }
};

Tile tile_of(const Stencil& stencil, int32_t number) {
  const int32_t begin = number * RowTiles::kRows;
  return {begin, std::min(begin + RowTiles::kRows, static_cast<int32_t>(stencil.mask.size()))};
}

void find_rows(const Stencil& stencil, const Tile& tile, std::vector<RowTiles::Row>& rows) {
  for (int32_t row = tile.begin; row < tile.end; ++row) {
    const int64_t length = stencil.row_start[row + 1] - stencil.row_start[row];
    rows[row] = {static_cast<uint16_t>(stencil.corner_of_row[row] - tile.begin),
                 static_cast<uint16_t>(length / Stencil::kRowPadding)};
  }
}

std::vector<int32_t> halo_of(const Stencil& stencil, const Tile& tile) {
  std::vector<int32_t> halo;
  for (int64_t k = stencil.row_start[tile.begin]; k < stencil.row_start[tile.end]; ++k)
    if (!tile.has(stencil.column[k])) halo.push_back(stencil.column[k]);
  sort_once(halo);
  return halo;
}

void find_local(const Stencil& stencil, const Tile& tile, const std::vector<int32_t>& halo,
                std::vector<uint16_t>& twice_local) {
  for (int64_t k = stencil.row_start[tile.begin]; k < stencil.row_start[tile.end]; ++k) {
    const int32_t column = stencil.column[k];
    const int64_t place =
        tile.has(column) ? column - tile.begin
                         : tile.rows() + (std::ranges::lower_bound(halo, column) - halo.begin());
    twice_local[k] = static_cast<uint16_t>(2 * place);
  }
}

}  // namespace

RowTiles make_row_tiles(const Stencil& stencil, int32_t width_max) {
  const auto n = static_cast<int32_t>(stencil.mask.size());
  const int32_t count = (n + RowTiles::kRows - 1) / RowTiles::kRows;
  RowTiles tiles;
  tiles.row.resize(n);
  tiles.twice_local.resize(stencil.column.size());
  tiles.is_wide.resize(count);
  std::vector<std::vector<int32_t>> halos(count);
  int32_t widest = 0;
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic, 16) reduction(max : widest)
  for (int32_t number = 0; number < count; ++number) {
    failure.run([&] {
      const Tile tile = tile_of(stencil, number);
      find_rows(stencil, tile, tiles.row);
      std::vector<int32_t> halo = halo_of(stencil, tile);
      const auto width = tile.rows() + static_cast<int32_t>(halo.size());
      tiles.is_wide[number] = width > width_max;
      if (width > width_max) return;
      widest = std::max(widest, width);
      find_local(stencil, tile, halo, tiles.twice_local);
      halos[number] = std::move(halo);
    });
  }
  failure.rethrow();
  tiles.width_max = widest;
  for (const std::vector<int32_t>& halo : halos) tiles.halo.add(halo);
  return tiles;
}

}  // namespace burnish

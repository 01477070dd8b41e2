#include "server/solver/hierarchy/row_tiles.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/base/parallel.h"
#include "common/base/resize_touched.h"
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

/// Finds the halos of tiles, one after the other, and places in them. A bit for each corner: a halo
/// is sorted by few words of bits, and a place is a count of bits.
class HaloFinder {
 public:
  explicit HaloFinder(size_t corners) : words_(corners / kBits + 1), before_(words_.size()) {}

  /// Returns the halo, rising; place_of() is that in this one.
  std::vector<int32_t> find(const Stencil& stencil, const Tile& tile) {
    for (const int32_t word : used_) words_[word] = 0;
    used_.clear();
    for (int64_t k = stencil.row_start[tile.begin]; k < stencil.row_start[tile.end]; ++k)
      if (!tile.has(stencil.column[k])) insert(stencil.column[k]);
    std::ranges::sort(used_);
    std::vector<int32_t> halo;
    for (const int32_t word : used_) {
      before_[word] = static_cast<int32_t>(halo.size());
      for (uint64_t left = words_[word]; left != 0; left &= left - 1)
        halo.push_back(kBits * word + __builtin_ctzll(left));
    }
    return halo;
  }

  int32_t place_of(int32_t corner) const {
    const uint64_t below = (uint64_t{1} << corner % kBits) - 1;
    return before_[corner / kBits] + __builtin_popcountll(words_[corner / kBits] & below);
  }

 private:
  static constexpr int32_t kBits = 64;

  void insert(int32_t corner) {
    uint64_t& word = words_[corner / kBits];
    if (word == 0) used_.push_back(corner / kBits);
    word |= uint64_t{1} << corner % kBits;
  }

  std::vector<uint64_t> words_;
  std::vector<int32_t> before_;  // per used word: corners of the halo in the words before
  std::vector<int32_t> used_;
};

void find_local(const Stencil& stencil, const Tile& tile, const HaloFinder& halo,
                std::vector<uint16_t>& twice_local) {
  for (int64_t k = stencil.row_start[tile.begin]; k < stencil.row_start[tile.end]; ++k) {
    const int32_t column = stencil.column[k];
    const int32_t place =
        tile.has(column) ? column - tile.begin : tile.rows() + halo.place_of(column);
    twice_local[k] = static_cast<uint16_t>(2 * place);
  }
}

}  // namespace

RowTiles make_row_tiles(const Stencil& stencil, int32_t width_max) {
  const auto n = static_cast<int32_t>(stencil.mask.size());
  const int32_t count = (n + RowTiles::kRows - 1) / RowTiles::kRows;
  RowTiles tiles;
  resize_touched(tiles.row, n);
  resize_touched(tiles.twice_local, stencil.column.size());
  tiles.is_wide.resize(count);
  std::vector<std::vector<int32_t>> halos(count);
  int32_t widest = 0;
  ParallelFailure failure;
#pragma omp parallel reduction(max : widest)
  {
    std::optional<HaloFinder> finder;
    failure.run([&] { finder.emplace(n); });
#pragma omp for schedule(dynamic, 16)
    for (int32_t number = 0; number < count; ++number) {
      failure.run([&] {
        const Tile tile = tile_of(stencil, number);
        find_rows(stencil, tile, tiles.row);
        std::vector<int32_t> halo = finder->find(stencil, tile);
        const auto width = tile.rows() + static_cast<int32_t>(halo.size());
        tiles.is_wide[number] = width > width_max;
        if (width > width_max) return;
        widest = std::max(widest, width);
        find_local(stencil, tile, *finder, tiles.twice_local);
        halos[number] = std::move(halo);
      });
    }
  }
  failure.rethrow();
  tiles.width_max = widest;
  tiles.halo.start.reserve(count + 1);
  for (const std::vector<int32_t>& halo : halos)
    tiles.halo.start.push_back(tiles.halo.start.back() + static_cast<int64_t>(halo.size()));
  resize_touched(tiles.halo.item, tiles.halo.start.back());
#pragma omp parallel for schedule(static)
  for (int32_t number = 0; number < count; ++number)
    std::ranges::copy(halos[number], tiles.halo.item.begin() + tiles.halo.start[number]);
  return tiles;
}

}  // namespace burnish

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/grid/stencil_slots.h"
#include "server/solver/cpu/cpu_depth.h"

/// The common part of products of a depth's rows with a vector: the way through the rows of a tile.
/// All of it, lambdas too, is inlined into loops for each level of x86-64 (dispatch.h).
#define BURNISH_INLINE __attribute__((always_inline))

namespace burnish::cpu {

inline constexpr int32_t kRowsAtOnce = 4;  // a cache line holds the numbers of this many corners

/// A corner's three columns and a spare one, as the compiler's own registers.
using Lanes = float __attribute__((vector_size(16)));
using DoubleLanes = double __attribute__((vector_size(32)));

inline const Lanes* lanes(const std::vector<Float4>& v) {
  return reinterpret_cast<const Lanes*>(v.data());
}
inline Lanes* lanes(std::vector<Float4>& v) {
  return reinterpret_cast<Lanes*>(v.data());
}

[[gnu::always_inline]] inline void load(const Lanes& from, Lanes& to) {
  to = from;
}
[[gnu::always_inline]] inline void load(const DoubleLanes& from, DoubleLanes& to) {
  to = from;
}
[[gnu::always_inline]] inline void load(const Lanes& from, DoubleLanes& to) {
  to = __builtin_convertvector(from, DoubleLanes);
}
[[gnu::always_inline]] inline void load(const Double3& from, DoubleLanes& to) {
  to = DoubleLanes{from[0], from[1], from[2], 0};
}

enum class Use { kRead, kWrite };

/// Prefetches `count` numbers into the second cache: the working set of a tile fills the first.
template <Use kUse = Use::kRead, typename Number>
[[gnu::always_inline]] inline void ask(const Number* numbers, size_t count = kRowsAtOnce) {
  constexpr size_t kCacheLine = 64;
  constexpr int kSecondCache = 2;
  const auto* first = reinterpret_cast<const char*>(numbers);
  for (size_t i = 0; i < count * sizeof(Number); i += kCacheLine)
    __builtin_prefetch(first + i, kUse == Use::kWrite, kSecondCache);
}

/// A matrix on a depth's stencil, as plain pointers.
template <typename T>
struct Rows {
  const int64_t* start;
  const int32_t* column;
  const RowTiles& tiles;
  const T* entry;
  const T* diagonal;  // by corner; for the exact matrix, the row sum

  Rows(const Stencil& stencil, const std::vector<T>& entries, const std::vector<T>& diagonals)
      : start(stencil.row_start.data()),
        column(stencil.column.data()),
        tiles(stencil.tiles),
        entry(entries.data()),
        diagonal(diagonals.data()) {}
};

/// A thread's working set of a tile: a vector's numbers at its corners and halo, and the sums of
/// its rows by corner. It is not cleared: that would take as long as some of the rows.
template <typename Number, typename Sum>
struct Room {
  std::unique_ptr<Number[]> x;
  std::unique_ptr<Sum[]> sum;

  explicit Room(const CpuDepth& depth)
      : x(std::make_unique_for_overwrite<Number[]>(depth.topology.stencil.tiles.width_max)),
        sum(std::make_unique_for_overwrite<Sum[]>(RowTiles::kRows)) {}
};

/// Returns where in x a tile finds its numbers of other tiles' corners.
[[gnu::always_inline]] inline std::span<const int32_t> halo_of(const RowTiles& tiles,
                                                               int32_t tile) {
  return tile < tiles.count() ? tiles.halo[tile] : std::span<const int32_t>();
}

/// Copies a tile's numbers.
template <typename Number, typename Vector>
[[gnu::always_inline]] inline void fill(Number* room, const Vector* x,
                                        std::span<const int32_t> halo, int32_t first,
                                        int32_t last) {
  for (int32_t i = first; i < last; ++i) load(x[i], *room++);
  for (const int32_t i : halo) load(x[i], *room++);
}

/// Returns a vector's number at the column of entry k.
template <typename Vector>
struct AtColumn {
  const Vector* x;
  const int32_t* column;
  [[gnu::always_inline]] const Vector& operator()(int64_t k) const { return x[column[k]]; }
};

/// Returns the same number from a tile's room. Four floats need no arithmetic, because a processor
/// multiplies an index by eight.
template <typename Number>
struct AtPlace {
  const Number* x;
  const uint16_t* twice;
  [[gnu::always_inline]] const Number& operator()(int64_t k) const {
    constexpr size_t kHalf = sizeof(Number) / 2;
    return *reinterpret_cast<const Number*>(reinterpret_cast<const char*>(x) + kHalf * twice[k]);
  }
};

/// Sums a tile's rows into the room: sum_row(begin, end, x at the row's corner, x at columns, sum)
/// gets a row's entries. It prefetches later numbers meanwhile, because a processor's own
/// prefetching ends at each page: the entries of rows further on, the next tile's copies, and by
/// ask_for(corner) the numbers that finish the sums of kRowsAtOnce corners.
template <typename T, typename Vector, typename Number, typename Sum, typename SumRow,
          typename AskFor>
[[gnu::always_inline]] inline void sum_rows(const Rows<T>& a, const Vector* x,
                                            Room<Number, Sum>& room, int32_t first, int32_t last,
                                            SumRow&& sum_row, AskFor&& ask_for) {
  constexpr int64_t kEntriesAhead = 768;
  constexpr int64_t kLongestRow = kSlots;  // a missing line costs more than an extra one
  constexpr size_t kHaloAhead = 2 * kRowsAtOnce;
  const RowTiles& tiles = a.tiles;
  const int32_t tile = first / RowTiles::kRows;
  const auto sum_all = [&](const auto* here, const auto& at) BURNISH_INLINE {
    std::span<const int32_t> next_halo = halo_of(tiles, tile + 1);
    int64_t k = a.start[first];
    for (int32_t begin = first; begin < last; begin += kRowsAtOnce) {
      ask_for(begin);
      ask(a.diagonal + begin);
      ask(x + begin + RowTiles::kRows);
      const size_t ahead = std::min(kHaloAhead, next_halo.size());
      for (const int32_t i : next_halo.first(ahead)) ask(x + i, 1);
      next_halo = next_halo.subspan(ahead);
      for (int32_t row = begin; row < std::min(begin + kRowsAtOnce, last); ++row) {
        ask(a.entry + k + kEntriesAhead, kLongestRow);
        ask(tiles.twice_local.data() + k + kEntriesAhead, kLongestRow);
        const auto [place, groups] = tiles.row[row];
        const int64_t end = k + int64_t{groups} * Stencil::kRowPadding;
        sum_row(k, end, here[place], at, room.sum[place]);
        k = end;
      }
    }
  };
  if (tiles.is_wide[tile] != 0) {
    sum_all(x + first, AtColumn<Vector>{x, a.column});
  } else {
    fill(room.x.get(), x, halo_of(tiles, tile), first, last);
    sum_all(room.x.get(), AtPlace<Number>{room.x.get(), tiles.twice_local.data()});
  }
}

}  // namespace burnish::cpu

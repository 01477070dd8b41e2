#include "server/solver/cpu/row_products.h"

#include <algorithm>
#include <memory>
#include <span>

#include "common/base/dispatch.h"
#include "server/solver/cpu/blocks.h"

namespace burnish::cpu {

namespace {

#define BURNISH_INLINE __attribute__((always_inline))

constexpr int32_t kRowsAtOnce = 4;  // as a cache line has that many corners' numbers

// A corner's three columns and a spare, as the compiler's own registers.
using Lanes = float __attribute__((vector_size(16)));
using DoubleLanes = double __attribute__((vector_size(32)));

const Lanes* lanes(const std::vector<Float4>& v) {
  return reinterpret_cast<const Lanes*>(v.data());
}
Lanes* lanes(std::vector<Float4>& v) {
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

// Asks for `count` numbers that are needed in a while: into the second cache, as what a thread has
// at hand of a tile fills the first.
template <Use kUse = Use::kRead, typename Number>
[[gnu::always_inline]] inline void ask(const Number* numbers, size_t count = kRowsAtOnce) {
  constexpr size_t kCacheLine = 64;
  constexpr int kSecondCache = 2;
  const auto* first = reinterpret_cast<const char*>(numbers);
  for (size_t i = 0; i < count * sizeof(Number); i += kCacheLine)
    __builtin_prefetch(first + i, kUse == Use::kWrite, kSecondCache);
}

template <typename T>
struct Rows {
  const int64_t* start;
  const int32_t* column;
  const RowTiles& tiles;
  const T* entry;
  const T* diagonal;  // by corner; of the exact matrix the row sum

  Rows(const Stencil& stencil, const std::vector<T>& entries, const std::vector<T>& diagonals)
      : start(stencil.row_start.data()),
        column(stencil.column.data()),
        tiles(stencil.tiles),
        entry(entries.data()),
        diagonal(diagonals.data()) {}
};

// What a thread has at hand of a tile: a vector's numbers at its corners and halo, and the sums of
// its rows by corner. Not cleared: that would take as long as some of the rows.
template <typename Number, typename Sum>
struct Room {
  std::unique_ptr<Number[]> x;
  std::unique_ptr<Sum[]> sum;

  explicit Room(const CpuDepth& depth)
      : x(std::make_unique_for_overwrite<Number[]>(depth.topology.stencil.tiles.width_max)),
        sum(std::make_unique_for_overwrite<Sum[]>(RowTiles::kRows)) {}
};

// Where in x a tile finds its numbers of other tiles' corners.
[[gnu::always_inline]] inline std::span<const int32_t> halo_of(const RowTiles& tiles,
                                                               int32_t tile) {
  if (tile >= tiles.count()) return {};
  return {tiles.halo.data() + tiles.halo_start[tile],
          tiles.halo.data() + tiles.halo_start[tile + 1]};
}

// Copies a tile's numbers.
template <typename Number, typename Vector>
[[gnu::always_inline]] inline void fill(Number* room, const Vector* x,
                                        std::span<const int32_t> halo, int32_t first,
                                        int32_t last) {
  for (int32_t i = first; i < last; ++i) load(x[i], *room++);
  for (const int32_t i : halo) load(x[i], *room++);
}

// A vector's number at the column of entry k.
template <typename Vector>
struct AtColumn {
  const Vector* x;
  const int32_t* column;
  [[gnu::always_inline]] const Vector& operator()(int64_t k) const { return x[column[k]]; }
};

// The same in a tile's room: of four floats it needs no arithmetic, as a processor multiplies an
// index by eight.
template <typename Number>
struct AtPlace {
  const Number* x;
  const uint16_t* twice;
  [[gnu::always_inline]] const Number& operator()(int64_t k) const {
    constexpr size_t kHalf = sizeof(Number) / 2;
    return *reinterpret_cast<const Number*>(reinterpret_cast<const char*>(x) + kHalf * twice[k]);
  }
};

// Sums a tile's rows into the room: sum_row(begin, end, x at the row's corner, x at columns, sum)
// has a row's entries. What comes later is asked for meanwhile, as a processor's own foresight ends
// at each page: the entries of rows further on, what the next tile will copy, and by
// ask_for(corner) what is done with the sums of kRowsAtOnce corners.
template <typename T, typename Vector, typename Number, typename Sum, typename SumRow,
          typename AskFor>
[[gnu::always_inline]] inline void sum_rows(const Rows<T>& a, const Vector* x,
                                            Room<Number, Sum>& room, int32_t first, int32_t last,
                                            SumRow&& sum_row, AskFor&& ask_for) {
  constexpr int64_t kEntriesAhead = 768;
  constexpr int64_t kLongestRow = kSlots;
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

// Σ_J A_IJ x_J of a row: entries in fours, two to a register.
template <typename At>
[[gnu::always_inline]] inline void sum_row(const float* entry, int64_t begin, int64_t end,
                                           const At& at, Lanes& sum) {
  Float8 first = {}, second = {};
  for (int64_t k = begin; k < end; k += Stencil::kRowPadding) {
    Lanes e;
    __builtin_memcpy(&e, entry + k, sizeof e);
    first += __builtin_shufflevector(e, e, 0, 0, 0, 0, 1, 1, 1, 1) *
             __builtin_shufflevector(at(k), at(k + 1), 0, 1, 2, 3, 4, 5, 6, 7);
    second += __builtin_shufflevector(e, e, 2, 2, 2, 2, 3, 3, 3, 3) *
              __builtin_shufflevector(at(k + 2), at(k + 3), 0, 1, 2, 3, 4, 5, 6, 7);
  }
  first += second;
  sum = __builtin_shufflevector(first, first, 0, 1, 2, 3) +
        __builtin_shufflevector(first, first, 4, 5, 6, 7);
}

// Calls finish(corner, A x there) for the corners of whole tiles, and ask_for(corner) before.
template <typename AskFor, typename Finish>
[[gnu::always_inline]] inline void multiply(const Rows<float>& a, const Lanes* x,
                                            Room<Lanes, Lanes>& room, int32_t begin, int32_t end,
                                            AskFor&& ask_for, Finish&& finish) {
  for (int32_t first = begin; first < end; first += RowTiles::kRows) {
    const int32_t last = std::min(end, first + RowTiles::kRows);
    sum_rows(
        a, x, room, first, last,
        [&](int64_t k, int64_t row_end, const Lanes&, const auto& at, Lanes& sum)
            BURNISH_INLINE { sum_row(a.entry, k, row_end, at, sum); },
        ask_for);
    for (int32_t i = first; i < last; ++i) finish(i, a.diagonal[i] * x[i] + room.sum[i - first]);
  }
}

BURNISH_DISPATCH void residual_block(const Rows<float>& s, const float* inverse_diagonal,
                                     const Lanes* f, const Lanes* x, float length, float kept,
                                     Room<Lanes, Lanes>& room, Lanes* r, int32_t begin,
                                     int32_t end) {
  multiply(
      s, x, room, begin, end,
      [&](int32_t i) BURNISH_INLINE {
        ask(inverse_diagonal + i);
        ask(f + i);
        ask<Use::kWrite>(r + i);
      },
      [&](int32_t i, const Lanes& product) BURNISH_INLINE {
        Lanes next = length * (f[i] - product);
        if (kept != 0) next += kept * r[i];
        r[i] = inverse_diagonal[i] == 0 ? Lanes{} : next;
      });
}

BURNISH_DISPATCH void relax_block(const Rows<float>& a, const Lanes* source, float length,
                                  float kept, Room<Lanes, Lanes>& room, Lanes* x, int32_t begin,
                                  int32_t end) {
  multiply(
      a, source, room, begin, end, [&](int32_t i) BURNISH_INLINE { ask<Use::kWrite>(x + i); },
      [&](int32_t i, const Lanes& product) BURNISH_INLINE {
        Lanes next = length * product;
        if (kept != 0) next += kept * x[i];
        x[i] = next;
      });
}

// Σ_J S_IJ (p_J − p_I) of a row.
template <typename Number, typename At>
[[gnu::always_inline]] inline void sum_row(const double* entry, int64_t begin, int64_t end,
                                           const Number& at_corner, const At& at,
                                           DoubleLanes& sum) {
  DoubleLanes here = {}, there = {}, first = {}, second = {};
  load(at_corner, here);
  for (int64_t k = begin; k < end; k += 2) {
    load(at(k), there);
    first += entry[k] * (there - here);
    load(at(k + 1), there);
    second += entry[k + 1] * (there - here);
  }
  sum = first + second;
}

template <typename Vector, typename Number>
[[gnu::always_inline]] inline void exact_rows(const Rows<double>& s, const float* inverse_diagonal,
                                              const Vector* p, Room<Number, DoubleLanes>& room,
                                              Double3* q, int32_t begin, int32_t end) {
  for (int32_t first = begin; first < end; first += RowTiles::kRows) {
    const int32_t last = std::min(end, first + RowTiles::kRows);
    sum_rows(
        s, p, room, first, last,
        [&](int64_t k, int64_t row_end, const auto& here, const auto& at, DoubleLanes& sum)
            BURNISH_INLINE { sum_row(s.entry, k, row_end, here, at, sum); },
        [&](int32_t i) BURNISH_INLINE {
          ask(inverse_diagonal + i);
          ask<Use::kWrite>(q + i);
        });
    for (int32_t i = first; i < last; ++i) {
      DoubleLanes here;
      load(p[i], here);
      const DoubleLanes product = s.diagonal[i] * here + room.sum[i - first];
      const bool is_free = inverse_diagonal[i] != 0;
      for (int axis = 0; axis < 3; ++axis) q[i][axis] = is_free ? product[axis] : 0;
    }
  }
}

BURNISH_DISPATCH void exact_block(const Rows<double>& s, const float* inverse_diagonal,
                                  const Lanes* p, Room<Lanes, DoubleLanes>& room, Double3* q,
                                  int32_t begin, int32_t end) {
  exact_rows(s, inverse_diagonal, p, room, q, begin, end);
}

BURNISH_DISPATCH void exact_block(const Rows<double>& s, const float* inverse_diagonal,
                                  const Double3* p, Room<DoubleLanes, DoubleLanes>& room,
                                  Double3* q, int32_t begin, int32_t end) {
  exact_rows(s, inverse_diagonal, p, room, q, begin, end);
}

}  // namespace

void compute_residual(CpuDepth& depth, float length, float kept) {
  const Rows<float> s(depth.topology.stencil, depth.system.entry, depth.system.diagonal);
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    Room<Lanes, Lanes> room(depth);
    residual_block(s, depth.inverse_diagonal.data(), lanes(depth.f), lanes(depth.x), length, kept,
                   room, lanes(depth.r), begin, end);
  });
}

void relax_by(CpuDepth& depth, const StencilMatrix& a, const std::vector<Float4>& source,
              float length, float kept) {
  const Rows<float> rows(depth.topology.stencil, a.entry, a.diagonal);
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    Room<Lanes, Lanes> room(depth);
    relax_block(rows, lanes(source), length, kept, room, lanes(depth.x), begin, end);
  });
}

void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Float4>& p,
                   std::vector<Double3>& q, int32_t begin, int32_t end) {
  const Rows<double> rows(depth.topology.stencil, s.entry, s.row_sum);
  Room<Lanes, DoubleLanes> room(depth);
  exact_block(rows, depth.inverse_diagonal.data(), lanes(p), room, q.data(), begin, end);
}

void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Double3>& p,
                   std::vector<Double3>& q, int32_t begin, int32_t end) {
  const Rows<double> rows(depth.topology.stencil, s.entry, s.row_sum);
  Room<DoubleLanes, DoubleLanes> room(depth);
  exact_block(rows, depth.inverse_diagonal.data(), p.data(), room, q.data(), begin, end);
}

}  // namespace burnish::cpu

#include "server/solver/cpu/row_products.h"

#include <algorithm>
#include <memory>

#include "common/base/dispatch.h"
#include "server/solver/cpu/blocks.h"

namespace burnish::cpu {

namespace {

// A corner's three columns and a spare, as the compiler's own registers. Arrays are only aligned to
// what the baseline's registers need.
using Lanes = float __attribute__((vector_size(16)));
using DoubleLanes = double __attribute__((vector_size(32), aligned(16)));

const Lanes* lanes(const std::vector<Float4>& v) {
  return reinterpret_cast<const Lanes*>(v.data());
}
Lanes* lanes(std::vector<Float4>& v) {
  return reinterpret_cast<Lanes*>(v.data());
}
const DoubleLanes* lanes(const std::vector<Double4>& v) {
  return reinterpret_cast<const DoubleLanes*>(v.data());
}
DoubleLanes* lanes(std::vector<Double4>& v) {
  return reinterpret_cast<DoubleLanes*>(v.data());
}

template <typename T>
struct Rows {
  const int32_t* corner;  // of a row
  const int64_t* start;
  const int32_t* column;
  const RowTiles& tiles;
  const T* entry;
  const T* diagonal;  // by corner; of the exact matrix the row sum

  Rows(const Stencil& stencil, const std::vector<T>& entries, const std::vector<T>& diagonals)
      : corner(stencil.corner_of_row.data()),
        start(stencil.row_start.data()),
        column(stencil.column.data()),
        tiles(stencil.tiles),
        entry(entries.data()),
        diagonal(diagonals.data()) {}
};

// Asks for what rows further on will need: a processor's own foresight ends at each page, and does
// not see through the order of the rows in a window.
constexpr int32_t kCornersAhead = 2 * Stencil::kRowWindow;
constexpr int64_t kEntriesAhead = 768;

template <typename T, typename... Vectors>
[[gnu::always_inline]] inline void fetch_ahead(const Rows<T>& a, int32_t row,
                                               const Vectors*... vectors) {
  __builtin_prefetch(a.entry + a.start[row] + kEntriesAhead);
  __builtin_prefetch(a.tiles.local.data() + a.start[row] + kEntriesAhead);
  (__builtin_prefetch(vectors + row + kCornersAhead), ...);
}

// Room for a tile. Not cleared: that would take as long as some of its rows.
template <typename Vector>
auto make_room(const CpuDepth& depth) {
  return std::make_unique_for_overwrite<Vector[]>(depth.topology.stencil.tiles.width_max);
}

// Copies a tile's numbers, and asks for what the next one will copy from elsewhere.
template <typename Vector>
[[gnu::always_inline]] inline void fill(Vector* room, const Vector* x, const RowTiles& tiles,
                                        int32_t tile, int32_t first, int32_t last) {
  for (int32_t i = first; i < last; ++i) *room++ = x[i];
  const int64_t begin = tiles.halo_start[tile], end = tiles.halo_start[tile + 1];
  const int32_t* halo = tiles.halo.data();
  for (int64_t h = begin; h < end; ++h) *room++ = x[halo[h]];
  const int64_t next_end = tiles.halo_start[std::min(tile + 2, tiles.count())];
  for (int64_t h = end; h < next_end; ++h) __builtin_prefetch(x + halo[h]);
}

// A vector's number at the column of entry k.
template <typename Vector, typename Index>
struct AtColumn {
  const Vector* x;
  const Index* column;
  [[gnu::always_inline]] const Vector& operator()(int64_t k) const { return x[column[k]]; }
};

// Calls visit(row, x at its corner, x at columns) for rows of whole tiles.
template <typename T, typename Vector, typename Visit>
[[gnu::always_inline]] inline void visit_rows(const Rows<T>& a, const Vector* x, Vector* room,
                                              int32_t begin, int32_t end, Visit&& visit) {
  for (int32_t first = begin; first < end; first += RowTiles::kRows) {
    const int32_t last = std::min(end, first + RowTiles::kRows), tile = first / RowTiles::kRows;
    if (a.tiles.is_wide[tile] != 0) {
      const AtColumn<Vector, int32_t> at{x, a.column};
      for (int32_t row = first; row < last; ++row) visit(row, x[a.corner[row]], at);
    } else {
      fill(room, x, a.tiles, tile, first, last);
      const AtColumn<Vector, uint16_t> at{room, a.tiles.local.data()};
      for (int32_t row = first; row < last; ++row) visit(row, room[a.corner[row] - first], at);
    }
  }
}

// Σ_J A_IJ x_J: entries in fours, two to a register.
template <typename At>
[[gnu::always_inline]] inline Lanes sum_row(const Rows<float>& a, int32_t row, const At& at) {
  Float8 first = {}, second = {};
  for (int64_t k = a.start[row]; k < a.start[row + 1]; k += Stencil::kRowPadding) {
    Lanes e;
    __builtin_memcpy(&e, a.entry + k, sizeof e);
    first += __builtin_shufflevector(e, e, 0, 0, 0, 0, 1, 1, 1, 1) *
             __builtin_shufflevector(at(k), at(k + 1), 0, 1, 2, 3, 4, 5, 6, 7);
    second += __builtin_shufflevector(e, e, 2, 2, 2, 2, 3, 3, 3, 3) *
              __builtin_shufflevector(at(k + 2), at(k + 3), 0, 1, 2, 3, 4, 5, 6, 7);
  }
  first += second;
  return __builtin_shufflevector(first, first, 0, 1, 2, 3) +
         __builtin_shufflevector(first, first, 4, 5, 6, 7);
}

#define BURNISH_INLINE __attribute__((always_inline))

BURNISH_DISPATCH void residual_block(const Rows<float>& s, const float* inverse_diagonal,
                                     const Lanes* f, const Lanes* x, Lanes* room, Lanes* r,
                                     int32_t begin, int32_t end) {
  const auto visit = [&](int32_t row, const Lanes& here, const auto& at) BURNISH_INLINE {
    fetch_ahead(s, row, f, r);
    const int32_t corner = s.corner[row];
    const Lanes product = s.diagonal[corner] * here + sum_row(s, row, at);
    r[corner] = inverse_diagonal[corner] == 0 ? Lanes{} : f[corner] - product;
  };
  visit_rows(s, x, room, begin, end, visit);
}

BURNISH_DISPATCH void relax_block(const Rows<float>& a, const Lanes* source, ChebyshevStep step,
                                  bool from_zero, const Lanes* last_d, Lanes* room, Lanes* d,
                                  Lanes* x, int32_t begin, int32_t end) {
  const auto visit = [&](int32_t row, const Lanes& here, const auto& at) BURNISH_INLINE {
    fetch_ahead(a, row, x);
    const int32_t corner = a.corner[row];
    const Lanes product = a.diagonal[corner] * here + sum_row(a, row, at);
    Lanes along = step.length * product;
    if (last_d != nullptr) along += step.momentum * last_d[corner];
    if (d != nullptr) d[corner] = along;
    x[corner] = from_zero ? along : x[corner] + along;
  };
  visit_rows(a, source, room, begin, end, visit);
}

template <typename Vector>
[[gnu::always_inline]] inline void exact_rows(const Rows<double>& s, const float* inverse_diagonal,
                                              const Vector* p, Vector* room, DoubleLanes* q,
                                              int32_t begin, int32_t end) {
  const auto visit = [&](int32_t row, const Vector& at_corner, const auto& at) BURNISH_INLINE {
    fetch_ahead(s, row, q);
    const int32_t corner = s.corner[row];
    const DoubleLanes here = __builtin_convertvector(at_corner, DoubleLanes);
    DoubleLanes sum = s.diagonal[corner] * here;
    DoubleLanes second = {};
    for (int64_t k = s.start[row]; k < s.start[row + 1]; k += 2) {
      sum += s.entry[k] * (__builtin_convertvector(at(k), DoubleLanes) - here);
      second += s.entry[k + 1] * (__builtin_convertvector(at(k + 1), DoubleLanes) - here);
    }
    q[corner] = inverse_diagonal[corner] == 0 ? DoubleLanes{} : sum + second;
  };
  visit_rows(s, p, room, begin, end, visit);
}

BURNISH_DISPATCH void exact_block(const Rows<double>& s, const float* inverse_diagonal,
                                  const Lanes* p, Lanes* room, DoubleLanes* q, int32_t begin,
                                  int32_t end) {
  exact_rows(s, inverse_diagonal, p, room, q, begin, end);
}

BURNISH_DISPATCH void exact_block(const Rows<double>& s, const float* inverse_diagonal,
                                  const DoubleLanes* p, DoubleLanes* room, DoubleLanes* q,
                                  int32_t begin, int32_t end) {
  exact_rows(s, inverse_diagonal, p, room, q, begin, end);
}

}  // namespace

void compute_residual(CpuDepth& depth) {
  const Rows<float> s(depth.topology.stencil, depth.system.entry, depth.system.diagonal);
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    const auto room = make_room<Lanes>(depth);
    residual_block(s, depth.inverse_diagonal.data(), lanes(depth.f), lanes(depth.x), room.get(),
                   lanes(depth.r), begin, end);
  });
}

void relax_along(CpuDepth& depth, const StencilMatrix& a, const RelaxAlong& relax) {
  const Rows<float> rows(depth.topology.stencil, a.entry, a.diagonal);
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    const auto room = make_room<Lanes>(depth);
    relax_block(rows, lanes(relax.source), relax.step, relax.from_zero,
                relax.last_d != nullptr ? lanes(*relax.last_d) : nullptr, room.get(),
                relax.d != nullptr ? lanes(*relax.d) : nullptr, lanes(depth.x), begin, end);
  });
}

void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Float4>& p,
                   std::vector<Double4>& q, int32_t begin, int32_t end) {
  const Rows<double> rows(depth.topology.stencil, s.entry, s.row_sum);
  const auto room = make_room<Lanes>(depth);
  exact_block(rows, depth.inverse_diagonal.data(), lanes(p), room.get(), lanes(q), begin, end);
}

void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Double4>& p,
                   std::vector<Double4>& q, int32_t begin, int32_t end) {
  const Rows<double> rows(depth.topology.stencil, s.entry, s.row_sum);
  const auto room = make_room<DoubleLanes>(depth);
  exact_block(rows, depth.inverse_diagonal.data(), lanes(p), room.get(), lanes(q), begin, end);
}

}  // namespace burnish::cpu

#include "server/solver/cpu/products/products.h"

#include "common/base/blocks.h"
#include "common/base/dispatch.h"
#include "server/solver/cpu/products/row_sums.h"

namespace burnish::cpu {

namespace {

// Returns Σ_J A_IJ x_J of a row: entries in fours, two to a register.
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

// Calls finish(corner, A x there) for the corners of whole tiles, and ask_for(corner) before it.
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

}  // namespace burnish::cpu

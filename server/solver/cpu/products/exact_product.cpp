#include "server/solver/cpu/products/exact_product.h"

#include "common/base/dispatch.h"
#include "server/solver/cpu/products/row_sums.h"

namespace burnish::cpu {

namespace {

// Returns Σ_J S_IJ (p_J − p_I) of a row.
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

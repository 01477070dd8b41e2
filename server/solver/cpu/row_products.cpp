#include "server/solver/cpu/row_products.h"

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
  const T* entry;
  const T* diagonal;  // by corner; of the exact matrix the row sum

  Rows(const Stencil& stencil, const std::vector<T>& entries, const std::vector<T>& diagonals)
      : corner(stencil.corner_of_row.data()),
        start(stencil.row_start.data()),
        column(stencil.column.data()),
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
  __builtin_prefetch(a.column + a.start[row] + kEntriesAhead);
  (__builtin_prefetch(vectors + row + kCornersAhead), ...);
}

// Σ_J A_IJ x_J: entries in fours, two to a register.
[[gnu::always_inline]] inline void add_row(const Rows<float>& a, const Lanes* x, int64_t begin,
                                           int64_t end, Lanes& sum) {
  Float8 first = {}, second = {};
  for (int64_t k = begin; k < end; k += Stencil::kRowPadding) {
    Lanes e;
    __builtin_memcpy(&e, a.entry + k, sizeof e);
    const int32_t* c = a.column + k;
    first += __builtin_shufflevector(e, e, 0, 0, 0, 0, 1, 1, 1, 1) *
             __builtin_shufflevector(x[c[0]], x[c[1]], 0, 1, 2, 3, 4, 5, 6, 7);
    second += __builtin_shufflevector(e, e, 2, 2, 2, 2, 3, 3, 3, 3) *
              __builtin_shufflevector(x[c[2]], x[c[3]], 0, 1, 2, 3, 4, 5, 6, 7);
  }
  first += second;
  sum += __builtin_shufflevector(first, first, 0, 1, 2, 3) +
         __builtin_shufflevector(first, first, 4, 5, 6, 7);
}

BURNISH_DISPATCH void residual_block(const Rows<float>& s, const float* inverse_diagonal,
                                     const Lanes* f, const Lanes* x, Lanes* r, int32_t begin,
                                     int32_t end) {
  for (int32_t row = begin; row < end; ++row) {
    fetch_ahead(s, row, f, x, r);
    const int32_t corner = s.corner[row];
    Lanes product = s.diagonal[corner] * x[corner];
    add_row(s, x, s.start[row], s.start[row + 1], product);
    r[corner] = inverse_diagonal[corner] == 0 ? Lanes{} : f[corner] - product;
  }
}

BURNISH_DISPATCH void relax_block(const Rows<float>& a, const Lanes* source, ChebyshevStep step,
                                  bool from_zero, const Lanes* last_d, Lanes* d, Lanes* x,
                                  int32_t begin, int32_t end) {
  for (int32_t row = begin; row < end; ++row) {
    fetch_ahead(a, row, source, x);
    const int32_t corner = a.corner[row];
    Lanes product = a.diagonal[corner] * source[corner];
    add_row(a, source, a.start[row], a.start[row + 1], product);
    Lanes along = step.length * product;
    if (last_d != nullptr) along += step.momentum * last_d[corner];
    if (d != nullptr) d[corner] = along;
    x[corner] = from_zero ? along : x[corner] + along;
  }
}

template <typename Vector>
[[gnu::always_inline]] inline void exact_rows(const Rows<double>& s, const float* inverse_diagonal,
                                              const Vector* p, DoubleLanes* q, int32_t begin,
                                              int32_t end) {
  for (int32_t row = begin; row < end; ++row) {
    fetch_ahead(s, row, p, q);
    const int32_t corner = s.corner[row];
    const DoubleLanes here = __builtin_convertvector(p[corner], DoubleLanes);
    DoubleLanes sum = s.diagonal[corner] * here;
    DoubleLanes second = {};
    for (int64_t k = s.start[row]; k < s.start[row + 1]; k += 2) {
      sum += s.entry[k] * (__builtin_convertvector(p[s.column[k]], DoubleLanes) - here);
      second += s.entry[k + 1] * (__builtin_convertvector(p[s.column[k + 1]], DoubleLanes) - here);
    }
    q[corner] = inverse_diagonal[corner] == 0 ? DoubleLanes{} : sum + second;
  }
}

BURNISH_DISPATCH void exact_block(const Rows<double>& s, const float* inverse_diagonal,
                                  const Lanes* p, DoubleLanes* q, int32_t begin, int32_t end) {
  exact_rows(s, inverse_diagonal, p, q, begin, end);
}

BURNISH_DISPATCH void exact_block(const Rows<double>& s, const float* inverse_diagonal,
                                  const DoubleLanes* p, DoubleLanes* q, int32_t begin,
                                  int32_t end) {
  exact_rows(s, inverse_diagonal, p, q, begin, end);
}

}  // namespace

void compute_residual(CpuDepth& depth) {
  const Rows<float> s(depth.topology.stencil, depth.system.entry, depth.system.diagonal);
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    residual_block(s, depth.inverse_diagonal.data(), lanes(depth.f), lanes(depth.x), lanes(depth.r),
                   begin, end);
  });
}

void relax_along(CpuDepth& depth, const StencilMatrix& a, const RelaxAlong& relax) {
  const Rows<float> rows(depth.topology.stencil, a.entry, a.diagonal);
  for_each_block(depth.corner_count(), [&](int32_t begin, int32_t end) {
    relax_block(rows, lanes(relax.source), relax.step, relax.from_zero,
                relax.last_d != nullptr ? lanes(*relax.last_d) : nullptr,
                relax.d != nullptr ? lanes(*relax.d) : nullptr, lanes(depth.x), begin, end);
  });
}

void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Float4>& p,
                   std::vector<Double4>& q, int32_t begin, int32_t end) {
  const Rows<double> rows(depth.topology.stencil, s.entry, s.row_sum);
  exact_block(rows, depth.inverse_diagonal.data(), lanes(p), lanes(q), begin, end);
}

void exact_product(const CpuDepth& depth, const ExactMatrix& s, const std::vector<Double4>& p,
                   std::vector<Double4>& q, int32_t begin, int32_t end) {
  const Rows<double> rows(depth.topology.stencil, s.entry, s.row_sum);
  exact_block(rows, depth.inverse_diagonal.data(), lanes(p), lanes(q), begin, end);
}

}  // namespace burnish::cpu

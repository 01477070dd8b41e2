#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "server/solver/cell_matrix.h"
#include "server/solver/hierarchy.h"

namespace burnish::cpu {

/// Three columns and one spare, so that a corner is one SSE register.
using Float4 = Eigen::Array4f;
using Double4 = Eigen::Array4d;

template <typename T>
uint64_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

/// A symmetric sparse matrix on a depth's stencil: off-diagonal entries in the stencil's order and
/// one number per row, the row sum (system matrix) or the diagonal (smoother).
struct StencilMatrix {
  std::vector<float> entry;
  std::vector<float> own;

  uint64_t byte_count() const { return bytes_of(entry) + bytes_of(own); }
};

/// One session's numbers at one depth.
struct CpuDepth {
  explicit CpuDepth(const HierarchyDepth& topology_of_depth);

  const HierarchyDepth& topology;
  std::vector<CellMatrix> cells;        ///< combined integrals
  StencilMatrix system;                 ///< S: own = row sums
  std::vector<float> inverse_diagonal;  ///< 0 where pinned
  std::vector<Float4> x, f;             ///< correction and right-hand side of the cycle
  std::vector<Float4> r;                ///< f − S x

  int32_t corner_count() const { return topology.grid.corner_count(); }
  uint64_t byte_count() const;
};

/// (S x)_I from row sums: Σ_J S_IJ (x_J − x_I) + m_I x_I loses nothing for smooth x.
template <typename Four>
Four system_row(const CpuDepth& depth, const std::vector<Four>& x, int32_t corner) {
  using Scalar = typename Four::Scalar;
  const Stencil& stencil = depth.topology.stencil;
  const Four here = x[corner];
  Four sum = static_cast<Scalar>(depth.system.own[corner]) * here;
  const int64_t end = stencil.row_start[corner + 1];
  for (int64_t k = stencil.row_start[corner]; k < end; ++k)
    sum += static_cast<Scalar>(depth.system.entry[k]) * (x[stencil.column[k]] - here);
  return sum;
}

/// r = f − S x, zero where pinned.
void compute_residual(CpuDepth& depth);

}  // namespace burnish::cpu

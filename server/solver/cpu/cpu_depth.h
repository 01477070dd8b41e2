#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "server/solver/cpu/halo.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cpu {

/// Three columns. The float form has a spare one, so that a corner is one SSE register.
using Float4 = Eigen::Array4f;
using Double3 = Eigen::Array3d;

template <typename T>
uint64_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

/// A symmetric sparse matrix on a depth's stencil, for the float32 cycle: off-diagonal entries in
/// the stencil's order, and the diagonal.
struct StencilMatrix {
  std::vector<float> entry;
  std::vector<float> diagonal;

  explicit StencilMatrix(const Stencil& stencil)
      : entry(stencil.column.size()), diagonal(stencil.mask.size()) {}
  uint64_t byte_count() const { return bytes_of(entry) + bytes_of(diagonal); }
};

/// S of the finest depth in double, by off-diagonals and row sums. The outer iteration converges to
/// its solution.
struct ExactMatrix {
  std::vector<double> entry;
  std::vector<double> row_sum;

  explicit ExactMatrix(const Stencil& stencil)
      : entry(stencil.column.size()), row_sum(stencil.mask.size()) {}
  uint64_t byte_count() const { return bytes_of(entry) + bytes_of(row_sum); }
};

/// So many depths, the finest first, do not keep the combined numbers of their cells: these take
/// 288 bytes a cell. A local new metric makes them again where it needs them.
inline constexpr size_t kDepthsNotKept = 3;

/// One session's numbers at one depth.
struct CpuDepth {
  /// `halo_of_depth`: null unless the depth is split.
  explicit CpuDepth(const HierarchyDepth& topology_of_depth, Halo* halo_of_depth = nullptr);

  const HierarchyDepth& topology;
  Halo* halo;                   ///< to the other shards; null if the depth is whole
  float anisotropy = 1;         ///< the largest ratio of α1 to α2, or α2 to α1, in any cell
  bool is_spectrum_new = true;  ///< λmax may have moved since its last estimate
  StencilMatrix system;         ///< S
  std::vector<float> inverse_diagonal;  ///< 0 where pinned
  std::vector<double> kept_numbers;     ///< of its cells and ties; none at kDepthsNotKept depths
  std::vector<Float4> x, f;             ///< correction and right-hand side of the cycle
  std::vector<Float4> r;                ///< f − S x

  int32_t corner_count() const { return topology.grid.corner_count(); }
  /// Returns whether the depth has a matrix. The border depth has one in the first shard alone.
  bool has_rows() const { return topology.stencil.mask.size() == topology.grid.corners.size(); }
  /// Brings the values of other shards to the ghosts.
  template <typename T>
  void refresh(std::vector<T>& vector) const {
    if (halo != nullptr) halo->refresh(topology.grid.depth, vector);
  }
  uint64_t byte_count() const;
};

/// Returns (A x)_I for smoothers that go from corner to corner; products.h has the fast loops.
inline Float4 product_row(const Stencil& stencil, const StencilMatrix& matrix,
                          const std::vector<Float4>& x, int32_t corner) {
  Float4 sum = matrix.diagonal[corner] * x[corner];
  for (auto [k, end] = stencil.row(corner); k < end; ++k)
    sum += matrix.entry[k] * x[stencil.column[k]];
  return sum;
}

}  // namespace burnish::cpu

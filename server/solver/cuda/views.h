#pragma once

#include <cstdint>
#include <vector_types.h>

// What kernels see: plain structs of device pointers, the same for nvcc and the host's compiler.
// Arrays that come from the host's structs have their layout (checked in device_mesh.cpp).

namespace burnish::cuda {

struct Double3 {
  double x, y, z;
};

/// Eight indices, -1 where there is none: SparseGrid's cell_corners and cells_of_corner.
struct Eight {
  int32_t at[8];
};

// Numbers of cells: all cells' first number, then all cells' second, and so on, so that threads of
// neighbouring cells read neighbouring numbers. Number i of cell c stands at i * cells + c.

/// CellIntegrals, without its gradients: mass (28), mass_row_sum (8), stiffness (2 × 28).
struct Integrals {
  static constexpr int kNumbers = 92;
  const double* numbers;
  int64_t cells;
};

/// CellIntegrals::gradient: for each corner a = 0..7 and direction i the three axes. That of a = 7
/// is minus the sum of the others; what its floats leave of it follows as another 2 × 3 numbers.
struct Gradients {
  static constexpr int kNumbers = 54;
  const float* numbers;
  int64_t cells;
};

/// The same of a session's metric, both directions in one: three axes for each corner, and what the
/// floats of a = 7 leave.
struct CellGradients {
  static constexpr int kNumbers = 27;
  float* numbers;
  int64_t cells;
};

/// β per cell as it was, and what it is to become.
struct NewGradientScale {
  float one;           ///< of the cells outside [begin, end)
  int64_t begin, end;  ///< where many are to be read; they may be the host's: each is read once
  const float* many;   ///< of every cell
  float* now;          ///< of every cell
  float* change;       ///< of every cell: working memory
};

/// Symmetric 8×8 matrices: off-diagonal pairs (28), and row sums or the diagonal (8).
template <typename Real>
struct CellSquares {
  static constexpr int kNumbers = 36;
  Real* numbers;
  int64_t cells;
};

/// DepthTransfer::FromCell.
struct FromCell {
  int32_t cell;
  uint8_t place;
};

/// EvaluationPoint.
struct VertexPlace {
  int32_t cell;
  float local[3];
};

inline constexpr int kSliceRows = 32;

/// A depth's stencil in slices of 32 rows, so that neighbouring threads read neighbouring entries:
/// entry k of row I stands at slice_start[I / 32] + 32 k + I % 32. Slices make groups, of which a
/// block of threads does one: see row_groups.h.
struct Rows {
  int32_t count;
  const int64_t* slice_start;
  const uint32_t* mask;   ///< Stencil::mask
  const uint16_t* local;  ///< one per entry: where in its group's tile its column stands
  int32_t group_rows;     ///< of every group but the last
  int32_t tile_max;       ///< the largest tile of a group
  int32_t group_count;
  const int32_t* halo_start;  ///< groups + 1
  const int32_t* halo;
};

/// One depth without any number that depends on the metric.
struct Topology {
  int32_t corner_count;
  int32_t cell_count;
  int64_t entry_count;
  Rows rows;
  const Eight* cell_corners;
  const Eight* cells_of_corner;
  const uint8_t* octant;       ///< which child of its parent a cell is
  const int32_t* child_start;  ///< null at the finest depth, as `child`
  const int32_t* child;
  const FromCell* prolongation;  ///< null at the coarsest depth, as the next two
  const int64_t* restriction_start;
  const uint32_t* restriction;  ///< packed.h
};

/// A symmetric matrix on a depth's stencil: off-diagonal entries with their columns (packed.h).
struct Matrix {
  uint32_t* packed;
  float* diagonal;
};

/// One session's numbers at one depth.
struct Depth {
  Topology topology;
  Matrix system;  ///< S
  float* rest;  ///< what S's packed entries leave of its entries; null between finest and coarsest
  float* inverse_diagonal;  ///< 0 where pinned
  float4* x;
  float4* f;
  float4* r;
};

/// A partial sum of a reduction (reduce.h), and how many of them one over all corners has at most.
template <int kCount>
struct Sums {
  double at[kCount];
};
inline constexpr int kPartialsMax = 1024;

/// Where the blocks of a kernel leave their sums, and how many have. Zero at first.
template <int kCount>
struct Partials {
  Sums<kCount>* sums;  ///< one a block
  unsigned* arrived;
};

}  // namespace burnish::cuda

#pragma once

#include <cstdint>
#include <vector_types.h>

// What kernels see: plain structs of device pointers, the same for nvcc and the host's compiler.
// Arrays that come from the host's structs have their layout (checked in device_mesh.cpp).

namespace burnish::cuda {

struct alignas(32) Double3 {
  double x, y, z, unused;
};

/// Eight indices, -1 where there is none: SparseGrid's cell_corners and cells_of_corner.
struct Eight {
  int32_t at[8];
};

/// CellIntegrals.
struct Integrals {
  double mass[28];
  double mass_row_sum[8];
  double stiffness[2][28];
  double gradient[2][21];
};

/// A symmetric 8×8 matrix of a cell: off-diagonal pairs, and row sums or the diagonal.
template <typename Real>
struct CellSquare {
  Real pair[28];
  Real own[8];
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
/// entry k of row I stands at slice_start[I / 32] + 32 k + I % 32.
struct Rows {
  int32_t count;
  const int64_t* slice_start;
  const uint32_t* mask;  ///< Stencil::mask
  const int32_t* column;
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
  const FromCell* prolongation;  ///< null at the coarsest depth, as the next three
  const int64_t* restriction_start;
  const int32_t* restriction_corner;
  const float* restriction_weight;
};

/// A symmetric matrix on a depth's stencil, float32.
struct Matrix {
  float* entry;
  float* diagonal;
};

/// One session's numbers at one depth.
struct Depth {
  Topology topology;
  Matrix system;            ///< S
  float* inverse_diagonal;  ///< 0 where pinned
  float4* x;
  float4* f;
  float4* r;
};

/// A partial sum of a reduction (reduce.h), and how many of them it has at most.
template <int kCount>
struct Sums {
  double at[kCount];
};
inline constexpr int kPartialsMax = 1024;

/// S of the finest depth in double, by off-diagonals and row sums.
struct ExactMatrix {
  double* entry;
  double* row_sum;
};

}  // namespace burnish::cuda

#pragma once

#include <cstdint>
#include <vector_types.h>

#include "common/grid/cell_corners.h"

// What kernels see: plain structs of device pointers, the same for nvcc and the host's compiler.
// Arrays that come from the host's structs have their layout (checked in device_mesh.cpp).

namespace burnish::cuda {

struct Double3 {
  double x, y, z;
};

/// Eight indices, -1 where there is none: SparseGrid's cell_corners and cells_of_corner. Aligned so
/// that two loads bring them.
struct alignas(16) Eight {
  int32_t at[8];
};

// Numbers of cells: all cells' first number, then all cells' second, and so on, so that threads of
// neighbouring cells read neighbouring numbers. Number i of cell c stands at i * cells + c.

/// CellIntegrals: the different masses (mass_places.h), mass_row_sum (8), stiffness (2 × 28).
struct Integrals {
  static constexpr int kMasses = 19, kRowSums = 8, kStiffnesses = 28;
  static constexpr int kNumbers = kMasses + kRowSums + 2 * kStiffnesses;
  const double* numbers;
  int64_t cells;
};

/// PreparedMesh::sheets that a hierarchy uses, with a sheet's integrals in place of a cell's.
struct SheetIntegrals {
  Integrals integrals;
  const int32_t* cell;  ///< of every sheet
};

/// What β−1 is multiplied by in each cell, α2/α1 g¹ + α1/α2 g²: for each corner three axes, and
/// what the floats of a = 7 leave. Where parts are weak also what all others leave: on cells with
/// next to no surface floats are enough to move such parts by 1e-4 of the diagonal.
struct CellGradients {
  static constexpr int kNumbers = 27, kRests = 21;
  float* numbers;
  float* rests;  ///< of a = 0..6; null where floats will do
  int64_t cells;
};

inline constexpr int kSliceRows = 32;

/// A cell's two principal curvatures. Units: user units.
struct Curvature {
  float kappa1, kappa2;
};

/// OwnFields of a cell.
struct OwnAlpha {
  int32_t cell;
  float alpha1, alpha2;
};

/// MetricView: what kernels work α of the cells out from.
struct AlphaSource {
  static constexpr int kPointsMax = 64;
  int32_t point_count;  ///< of the curve; with one of them and no `own` all cells have its α
  int32_t own_count;
  const OwnAlpha* own;  ///< by rising cell
  double kappa[kPointsMax], log_alpha[kPointsMax];
};

/// What a cell makes of the slider: its β is 1 + follow·(slider − 1) + own.
struct alignas(8) Paint {
  float follow, own;
};
inline constexpr Paint kNoPaint = {1, 0};

/// Some chunks (chunks.h) of cells, or all: what a kernel is started with rather than reads.
struct ChunkList {
  static constexpr int kMax = 512;
  int32_t count;
  bool is_all;
  int32_t chunk[kMax];
};

/// The slider as it was and as it is, and paint that is new in some chunks of cells.
struct NewGradientScale {
  double slider_before, slider;
  bool is_painted;    ///< whether any cell may have paint
  Paint* paint;       ///< of every cell, as it was until it is taken over
  const Paint* from;  ///< of the changed chunks' cells, one chunk after the other; may be
                      ///< the host's: each is read once
  ChunkList changed;
};

/// The right-hand side for the displacement: of corner I it is slider_less_one · per_slider[I], and
/// own[I] as well where slice I / kSliceRows of the corners is painted. Where I is pinned it counts
/// as zero; which corners are is the metric's to say, and these numbers outlive it.
struct Constraint {
  Double3 *per_slider, *own;
  double* slider_less_one;
  uint8_t* is_painted;  ///< of each slice: whether any cell there has paint
  uint8_t* is_touched;  ///< working memory: slices with cells whose paint is new
};

/// Symmetric 8×8 matrices: off-diagonal pairs (28), and row sums or the diagonal (8).
template <typename Real>
struct CellSquares {
  static constexpr int kNumbers = 36;
  Real* numbers;
  int64_t cells;
};

/// FromCell of coarse_grid.h; of a shared corner the cell is -1.
struct FromCell {
  int32_t cell;
  uint8_t place;
};

/// Some corners, and those of another depth that each takes from, by weight.
struct ListedCorners {
  int32_t count;
  const int32_t* corner;
  const int32_t* start;  ///< count + 1, into the next two
  const int32_t* from;
  const float* weight;
};

/// EvaluationPoint.
struct VertexPlace {
  int32_t cell;
  float local[3];
};

/// What rows have beyond kEntriesMax entries (packed.h): see long_rows.h. Null where none has any.
struct LongRows {
  const int32_t* start;  ///< corners + 1
  const int32_t* column;
  int32_t entry_count;
};

/// A depth's stencil in slices of 32 rows, so that neighbouring threads read neighbouring entries:
/// entry k of row I stands at slice_start[I / 32] + 32 k + I % 32. Slices make groups, of which a
/// block of threads does one: see row_groups.h.
struct Rows {
  int32_t count;
  const int64_t* slice_start;
  const uint32_t* mask;   ///< Stencil::mask; of an irregular row one with as many bits as it has
                          ///< entries here, the highest ones
  const uint16_t* local;  ///< one per entry: where in its group's tile its column stands
  int32_t group_rows;     ///< of every group but the last
  int32_t tile_max;       ///< the largest tile of a group
  int32_t group_count;
  const int32_t* halo_start;  ///< groups + 1
  const int32_t* halo;
  LongRows long_rows;
};

/// IrregularCells::entry.
struct PairEntries {
  uint16_t at[kPairsPerCell];
};

/// A depth's irregular rows and the cells at them (stencil.h). Sources are places among the depth's
/// numbers, which are CellSquares and behind them 64 of each tie; at the finest depth 64 of each
/// sheet.
struct Irregular {
  int32_t row_count;
  const int32_t* corner;
  const int64_t* sum_start;
  const int64_t* source_start;
  const int32_t* source;
  int32_t cell_count;
  const int32_t* cell;
  const PairEntries* entry;
};

/// CellPart and CellShare.
struct CellPart {
  float weight[8];
  uint8_t place[8];
};
struct CellShare {
  int32_t source, left, right, is_transposed;
};

/// What a depth's numbers take from those of the finer one beyond what children give: CellShares.
struct Shares {
  int32_t target_count;
  const CellPart* part;
  const int32_t* target;
  const int32_t* start;
  const CellShare* share;
  int32_t apart_count;
  const int32_t* apart;
};

/// Patches (patches.h).
struct PatchList {
  const int32_t* start;        ///< patches + 1, into `corner`
  const int32_t* corner;       ///< rising within a patch
  const int64_t* entry_start;  ///< patches + 1: of their lower triangles, by rows
};

/// One depth without any number that depends on the metric.
struct Topology {
  int32_t corner_count;
  int32_t cell_count;
  int64_t number_count;  ///< of its cells and ties: see Irregular
  int64_t entry_count;   ///< of its rows, packed
  Rows rows;
  const Eight* cell_corners;
  const Eight* cells_of_corner;  ///< none of the corner of an irregular row
  const uint8_t* octant;         ///< which child of its parent a cell is
  const int32_t* child_start;    ///< null at the finest depth, as `child`
  const int32_t* child;
  const FromCell* prolongation;  ///< null at the coarsest depth, as the next two
  const int64_t* restriction_start;
  const uint32_t* restriction;  ///< packed.h
  ListedCorners shared;         ///< DepthTransfer::SharedCorners
  ListedCorners listed;         ///< coarse corners that are not packed
  Irregular irregular;
  Shares shares;            ///< of this depth's numbers
  const uint8_t* is_exact;  ///< of each group of rows: whether residuals take S to all digits that
                            ///< are there, as around patches; null where none does
};

/// A symmetric matrix on a depth's stencil: off-diagonal entries with their columns (packed.h).
struct Matrix {
  uint32_t* packed;
  float* diagonal;
  float* long_entries;  ///< as they are, of LongRows::column; null where there are none
  float* rest;          ///< what the packed entries leave of each; null where that will do
};

/// One session's numbers at one depth.
struct Depth {
  Topology topology;
  Matrix system;     ///< S, with rests at the finest and coarsest depths and where is_exact
  float* remainder;  ///< what rests leave as well; at the finest depth where is_exact, else null
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

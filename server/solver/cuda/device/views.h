#pragma once

#include <cstdint>
#include <vector_types.h>

#include "common/grid/cell_corners.h"

// The data that kernels see: plain structs of device pointers, the same for nvcc and the host's
// compiler. Arrays from the host's structs have their layout (checked in device_mesh.cpp).

namespace burnish::cuda {

struct Double3 {
  double x, y, z;
};

/// Eight indices, -1 for none: SparseGrid's cell_corners and cells_of_corner. The alignment lets
/// two loads read them.
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

/// The PreparedMesh::sheets that a hierarchy uses, with a sheet's integrals in place of a cell's.
struct SheetIntegrals {
  Integrals integrals;
  const int32_t* cell;  ///< per sheet
};

/// The factor of β−1 in each cell, α2/α1 g¹ + α1/α2 g²: three axes for each corner, and the rests
/// of the floats of a = 7. At weak parts it also has the other rests: there the rounding of floats
/// on cells with almost no surface is enough to move the parts by 1e-4 of the diagonal.
struct CellGradients {
  static constexpr int kNumbers = 27, kRests = 21;
  float* numbers;
  float* rests;  ///< of a = 0..6; null if floats are enough
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

/// LineMass: its pairs, then its row sums.
struct HeldLine {
  static constexpr int kStretch = 1024;
  int32_t cell;
  double number[kPairsPerCell + 8];
};

/// MetricView: the kernels compute α of the cells from it.
struct AlphaSource {
  static constexpr int kPointsMax = 64;
  int32_t point_count;  ///< of the curve; one point without `own` gives all cells its α
  int32_t own_count;
  const OwnAlpha* own;        ///< by rising cell
  const HeldLine* lines;      ///< by rising cell
  const int32_t* first_line;  ///< per kStretch cells, and the end; null if nothing is held
  double kappa[kPointsMax], log_alpha[kPointsMax];
};

/// A cell's dependence on the slider: its β is 1 + follow·(slider − 1) + own.
struct alignas(8) Paint {
  float follow, own;
};
inline constexpr Paint kNoPaint = {1, 0};

/// Some chunks (chunks.h) of cells, or all. A kernel takes it as an argument, so it need not read
/// it.
struct ChunkList {
  static constexpr int kMax = 512;
  int32_t count;
  bool is_all;
  int32_t chunk[kMax];
};

/// The slider before and now, and new paint in some chunks of cells.
struct NewGradientScale {
  double slider_before, slider;
  bool is_painted;    ///< a cell may have paint
  Paint* paint;       ///< of every cell, as before the change
  const Paint* from;  ///< of the changed chunks' cells, one chunk after the other; it may be the
                      ///< host's: each value is read once
  ChunkList changed;
};

/// TargetGradient.
struct alignas(8) TargetMatrices {
  float of_scale[9], of_target[9];
};

/// TargetView.
struct NewTarget {
  const TargetMatrices* cells;  ///< null: there is no target
  const float* part;            ///< of the strength, per cell; null: 1 in all
  double strength;
  bool is_new;  ///< cells may have other shares than before
};

/// The right-hand side for the displacement. For corner I it is slider_less_one · per_slider[I]; if
/// slice I / kSliceRows of the corners is painted, plus own[I]. At pinned corners it counts as
/// zero. The metric says which corners are pinned, and these numbers outlive it.
struct Constraint {
  Double3 *per_slider, *own;
  double* slider_less_one;
  uint8_t* is_painted;  ///< per slice: a cell there has paint, or all cells have a target
  uint8_t* is_touched;  ///< working memory: slices with cells of new paint
};

/// Symmetric 8×8 matrices: off-diagonal pairs (28), and row sums or the diagonal (8).
template <typename Real>
struct CellSquares {
  static constexpr int kNumbers = 36;
  Real* numbers;
  int64_t cells;
};

/// FromCell of coarse_grid.h; a shared corner has cell -1.
struct FromCell {
  int32_t cell;
  uint8_t place;
};

/// Some corners, and the corners of another depth that each takes from, with weights.
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

/// The entries of rows beyond kEntriesMax (packed.h): see long_rows.h. Null if no row has any.
struct LongRows {
  const int32_t* start;  ///< corners + 1
  const int32_t* column;
  int32_t entry_count;
};

/// A depth's stencil in slices of 32 rows, so that neighbouring threads read neighbouring entries:
/// entry k of row I stands at slice_start[I / 32] + 32 k + I % 32. Slices form groups; a block of
/// threads does one group: see row_groups.h.
struct Rows {
  int32_t count;
  const int64_t* slice_start;
  const uint32_t* mask;   ///< Stencil::mask; an irregular row has its entries as the highest bits
  const uint16_t* local;  ///< one per entry: its column's place in the group's tile
  int32_t group_rows;     ///< of every group except the last
  int32_t tile_max;       ///< the largest tile of a group
  int32_t group_count;
  const int32_t* halo_start;  ///< groups + 1
  const int32_t* halo;
  LongRows long_rows;
  int32_t own_group_count;  ///< the first groups, which have a shard's own corners; or all
};

/// IrregularCells::entry.
struct PairEntries {
  uint16_t at[kPairsPerCell];
};

/// A depth's irregular rows and their cells (stencil.h). Sources are places among the depth's
/// numbers: CellSquares, then 64 of each tie; at the finest depth 64 of each sheet.
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

/// The shares of the finer depth's numbers beyond the children's: CellShares.
struct Shares {
  int32_t target_count;
  const CellPart* part;
  const int32_t* target;
  const int32_t* start;
  const int32_t* block;  ///< of parts, per target (touched_blocks.h)
  const CellShare* share;
  int32_t apart_count;
  const int32_t* apart;
};

/// A list of blocks, rising, among a session's lists: those from lists[number] on before
/// lists[number + 1]. By default there is none, which means all blocks.
struct BlockList {
  const int32_t* lists = nullptr;
  int32_t number = 0;
};

/// The blocks of one depth that a local new metric makes again (touched_blocks.h); by default all.
struct Touched {
  BlockList parts, rows, inverse_rows, inverses;
};

/// Patches (patches.h).
struct PatchList {
  const int32_t* start;        ///< patches + 1, into `corner`
  const int32_t* corner;       ///< rising within a patch
  const int64_t* entry_start;  ///< patches + 1; the patches' lower triangles, by rows
};

/// One depth without any number that depends on the metric.
struct Topology {
  int32_t corner_count;
  int32_t cell_count;
  int64_t number_count;  ///< of cells and ties: see Irregular
  int64_t entry_count;   ///< of its rows, packed
  Rows rows;
  const Eight* cell_corners;
  const Eight* cells_of_corner;  ///< none for the corner of an irregular row
  const uint8_t* octant;         ///< the octant of each cell in its parent
  const int32_t* child_start;    ///< null at the finest depth, like `child`
  const int32_t* child;
  const FromCell* prolongation;  ///< null at the coarsest depth, like the next two
  const int64_t* restriction_start;
  const uint32_t* restriction;  ///< packed.h
  ListedCorners shared;         ///< DepthTransfer::SharedCorners
  ListedCorners listed;         ///< coarse corners that are not packed
  Irregular irregular;
  Shares shares;            ///< for this depth's numbers
  const uint8_t* is_exact;  ///< per group of rows: residuals use all digits of S, as around
                            ///< patches; null if no group does
  int32_t own_count;        ///< a shard's own corners come first, then ghosts; or all
  int32_t known_count;      ///< the corners from here on are pinned
};

/// A symmetric matrix on a depth's stencil: off-diagonal entries with their columns (packed.h).
struct Matrix {
  uint32_t* packed;
  float* diagonal;
  float* long_entries;  ///< not packed, for LongRows::column; null if there are none
  float* rest;          ///< the rounding rest of each packed entry; null if not needed
};

/// One session's numbers at one depth.
struct Depth {
  Topology topology;
  Matrix system;     ///< S; with rests at the finest and coarsest depths and where is_exact
  float* remainder;  ///< the rounding of the rests; null except at the finest depth with is_exact
  float* inverse_diagonal;  ///< 0 where pinned
  float4* x;
  float4* f;
  float4* r;
};

/// A partial sum of a reduction (reduce.h), and the largest number of them for a sum over all
/// corners.
template <int kCount>
struct Sums {
  double at[kCount];
};
inline constexpr int kPartialsMax = 1024;

/// The totals of all shards of a scan (solver/multi), in their order. Other devices wrote them.
struct OfShards {
  static constexpr int kMax = 16, kTotals = 16;
  int count;
  const double* totals[kMax];
};

/// The sums of a kernel's blocks, and the number of blocks that are done. Zero at first.
template <int kCount>
struct Partials {
  Sums<kCount>* sums;  ///< one per block
  unsigned* arrived;
};

}  // namespace burnish::cuda

#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/evaluation/evaluation.h"
#include "common/frame_codec/frame_content.h"
#include "common/grid/sparse_grid.h"

namespace burnish {

inline constexpr int kTileValues = 2048;

/// The mesh that a client draws: the whole scan, or a proxy in the same grid.
struct FrameMesh {
  const SparseGrid& grid;                   ///< the finest depth
  std::span<const EvaluationPoint> points;  ///< one per vertex
};

/// The earlier values of the same tile that predict a value: v[a] + v[b] - v[c]. kTileValues stands
/// for zero.
struct Predictor {
  uint16_t a = kTileValues;
  uint16_t b = kTileValues;
  uint16_t c = kTileValues;
};

/// Says which values a frame carries and in what order. Both ends make it from the same evaluation
/// points, once per prepared mesh or proxy; clients and frames share it.
struct FrameLayout {
  FrameContent content = FrameContent::kCoefficients;
  std::vector<int32_t> source;        ///< the corner or vertex of each value, in Morton order
  std::vector<Predictor> predictors;  ///< one per value
  /// By how many half steps a value may be off while the surface moves: 1 for a vertex. For a
  /// corner it is the largest power of two whose product with the corner's largest weight on a
  /// vertex is at most 1/8, but at least 1. So corners that hardly weigh on the surface, whose
  /// values wander, do not keep tiles busy. All corners of a cell together move a vertex by at most
  /// two half steps.
  std::vector<uint16_t> slack;
  uint64_t fingerprint = 0;  ///< of content, source and predictors

  int value_count() const { return static_cast<int>(source.size()); }
  int tile_count() const { return (value_count() + kTileValues - 1) / kTileValues; }
  int tile_begin(int tile) const { return tile * kTileValues; }
  int tile_size(int tile) const { return std::min(kTileValues, value_count() - tile_begin(tile)); }
  uint64_t byte_count() const;
};

/// Leaves out corners that weigh on no vertex: nothing determines them, and they can run away.
/// Cost: O(vertices + corners log 2048).
FrameLayout make_coefficient_layout(const FrameMesh& mesh);

/// Leaves out vertices that lie in no cell: they never move. Cost: a sort of the vertices.
FrameLayout make_vertex_layout(const FrameMesh& mesh);

/// Makes the layout whose frames are likely smaller.
FrameLayout make_smaller_layout(const FrameMesh& mesh);

}  // namespace burnish

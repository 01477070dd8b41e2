#pragma once

#include <span>

#include "server/prepare/cell_pieces.h"
#include "server/prepare/curvature.h"
#include "server/prepare/unset_vector.h"

namespace burnish {

/// The curvature of the triangles of some pieces, made once for each triangle. Keeps its memory
/// from one batch to the next.
class PieceCurvature {
 public:
  explicit PieceCurvature(const MeshCurvature& curvature) : curvature_(curvature) {}

  void load(std::span<const CellPiece> pieces);

  /// Returns the curvature of a loaded piece's triangle.
  const TriangleCurvature& operator[](size_t piece) const { return loaded_[place_[piece]]; }

 private:
  struct PieceOfTriangle {
    uint32_t triangle;
    uint32_t piece;
  };

  const MeshCurvature& curvature_;
  UnsetVector<PieceOfTriangle> order_, spare_;
  UnsetVector<uint32_t> place_;      // per piece, in loaded_
  UnsetVector<uint32_t> triangles_;  // rising
  UnsetVector<TriangleCurvature> loaded_;
};

}  // namespace burnish

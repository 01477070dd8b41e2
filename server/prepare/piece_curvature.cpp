#include "server/prepare/piece_curvature.h"

#include <functional>

#include "server/prepare/radix_sort.h"

namespace burnish {

void PieceCurvature::load(std::span<const CellPiece> pieces) {
  order_.resize(pieces.size());
  spare_.resize(pieces.size());
  place_.resize(pieces.size());
  for (uint32_t i = 0; i < pieces.size(); ++i) order_[i] = {pieces[i].triangle, i};
  radix_sort(std::span(order_), std::span(spare_), std::mem_fn(&PieceOfTriangle::triangle));
  triangles_.clear();
  for (const PieceOfTriangle& of : order_) {
    if (triangles_.empty() || triangles_.back() != of.triangle) triangles_.push_back(of.triangle);
    place_[of.piece] = static_cast<uint32_t>(triangles_.size() - 1);
  }
  loaded_.resize(triangles_.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < triangles_.size(); ++i) loaded_[i] = curvature_.of(triangles_[i]);
}

}  // namespace burnish

#pragma once

#include "server/prepare/pages/page_piece.h"

namespace burnish {

/// How a piece loses triangles, from the one that is tried first to the one that always works.
enum class SimplifyBy {
  kCollapse,  ///< collapse_edges()
  kCluster,   ///< cluster_vertices()
  kDrop,      ///< drop_small_triangles(): the only one that may open gaps
};

/// Returns about half of a piece's triangles, at least one, or as few as its locks allow. Whatever
/// other pages share with the piece stays as it was, unless `by` is kDrop.
/// Needs: a piece with triangles.
SimplePiece simplify_piece(const PagePiece& piece, SimplifyBy by);

}  // namespace burnish

#pragma once

#include "server/prepare/pages/page_piece.h"

namespace burnish {

/// How a piece loses triangles, from the one that is tried first to the one that always works.
enum class SimplifyBy {
  kKeep,          ///< not at all: larger pages of the same detail follow
  kCollapse,      ///< collapse_edges(), and leaves part of the vertices inside as they are
  kCollapseMore,  ///< collapse_edges() until half is left, whatever it costs
  kCluster,       ///< cluster_vertices()
  kDrop,          ///< drop_small_triangles(): the only one that may open gaps
};

/// Returns about half of a piece's triangles, at least one, or as few as its locks allow. A piece
/// whose vertices are mostly locked keeps more by kCollapse: to halve it, all its other vertices
/// had to go, and the error would be many times that of the pages around it. Whatever other pages
/// share with the piece stays as it was, unless `by` is kDrop. Needs: a piece with triangles.
SimplePiece simplify_piece(const PagePiece& piece, SimplifyBy by);

}  // namespace burnish

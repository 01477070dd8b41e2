#pragma once

#include "server/prepare/pages/page_piece.h"

namespace burnish {

/// Joins the vertices in each cell of a lattice, as coarse a one as it takes to leave
/// `triangles_wanted`. Locked vertices stay where they are. For pieces that collapse_edges() cannot
/// simplify.
/// Deterministic.
SimplePiece cluster_vertices(const PagePiece& piece, size_t triangles_wanted);

/// Drops the smallest triangles until `triangles_wanted` are left, whatever gap that makes. For
/// tangles of triangles that share all their vertices with other pages.
/// Deterministic.
SimplePiece drop_small_triangles(const PagePiece& piece, size_t triangles_wanted);

}  // namespace burnish

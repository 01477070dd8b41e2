#pragma once

#include "server/prepare/pages/page_piece.h"

namespace burnish {

/// Collapses edges until `triangles_wanted` are left or nothing more can go. Locked vertices stay
/// where they are; the scan's own boundary may move.
/// Deterministic.
SimplePiece collapse_edges(const PagePiece& piece, size_t triangles_wanted);

}  // namespace burnish

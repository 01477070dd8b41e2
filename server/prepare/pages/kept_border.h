#pragma once

#include <utility>
#include <vector>

#include "server/prepare/pages/page_piece.h"

namespace burnish {

/// Parts of a piece that other pages rely on: its locked vertices, and the edges of its boundary
/// between two of them. Simplification moves no locked vertex, but it may remove all triangles
/// around one, for example the tip of a triangle whose other corners collapse.
class KeptBorder {
 public:
  explicit KeptBorder(const PagePiece& piece);

  /// Lists the locked vertices that are gone, and the ends of edges that the boundary has no longer
  /// or in another direction. None: other pages see no difference.
  std::vector<uint32_t> find_lost(const std::vector<Triangle>& simple) const;

 private:
  /// An edge between two vertices, and how often triangles pass it upwards minus downwards.
  struct Edge {
    uint64_t ends;
    int32_t passes;
  };
  std::vector<Edge> edges_of(const std::vector<Triangle>& triangles) const;

  const PagePiece& piece_;
  std::vector<Edge> edges_;
};

}  // namespace burnish

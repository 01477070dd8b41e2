#pragma once

#include <span>

#include "server/prepare/pages/cut_pages.h"

namespace burnish {

/// The triangles of one level, cut into pages.
struct CutLevel {
  std::span<const Triangle> triangles;
  std::span<const uint32_t> joined;  ///< as PageVertices::joined
  const PageGroups& pages;
};

/// Per joined vertex of the scan 1 if several pages of the level have it, else 0. Simplification
/// keeps such vertices where they are: so pages are replaced one by one without a crack. Throws:
/// WorkCancelled.
ScratchArray<uint8_t> find_shared_vertices(const CutLevel& level, const ScratchSpace& space,
                                           const LoopPart& part = kUnheardLoop);

}  // namespace burnish

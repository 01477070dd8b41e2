#pragma once

#include <span>
#include <vector>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/base/types.h"
#include "server/prepare/pages/page_texels.h"

namespace burnish {

/// Triangles of one level by page.
struct PageGroups {
  std::vector<uint64_t> start;  ///< pages + 1, into `item`
  ScratchArray<uint32_t> item;

  size_t count() const { return start.size() - 1; }
  std::span<const uint32_t> operator[](size_t page) const {
    return {item.data() + start[page], item.data() + start[page + 1]};
  }
};

/// The triangles of one level, and what decides where its pages end.
struct LevelToCut {
  std::span<const Triangle> triangles;
  std::span<const Vec3i> positions;    ///< per vertex of the scan, steps of the grid
  int bits = 0;                        ///< of the grid
  int level = 0;                       ///< moves the cuts, so that borders are not borders again
  double vertices_per_triangle = 0.5;  ///< expected of a page; decides how full pages get
  PageTexels texels = {};
};

/// Cuts a level into pages of at most kPageVerticesMax vertices and kPageTrianglesMax triangles,
/// and of as many texels as `texels` says. Where texels are denser in some parts, pages are as
/// small as their sheets need to show those, unless that makes very many pages. Triangles are first
/// dealt into runs of a Morton curve, then each run is halved again and again across the longest
/// side of its box, less that of a mean triangle where texels matter. Pages come in this order; the
/// triangles of a page rise. Deterministic: the same groups for any number of threads. Throws:
/// WorkCancelled.
PageGroups cut_pages(const LevelToCut& level, const ScratchSpace& space,
                     const LoopPart& part = kUnheardLoop);

}  // namespace burnish

#pragma once

#include <cstdint>

#include "common/base/groups.h"
#include "common/page_frames/page_corners.h"
#include "common/pages/page.h"

namespace burnish {

/// Says how many values a page has in a frame, and which earlier values predict each. Both ends
/// make it from the decoded page, and share it among frames.
struct PageLayout {
  /// Per value the earlier values whose mean predicts it, each once. Empty for the first value.
  Groups<uint16_t, uint16_t> predictors;
  uint32_t vertices = 0;  ///< of the page, whatever its values are

  uint32_t value_count() const { return static_cast<uint32_t>(predictors.count()); }
  uint64_t byte_count() const { return predictors.byte_count(); }
};

/// A value per vertex, in the page's order as decoded. The predictors of a vertex are the earlier
/// vertices of its triangles, else the vertex before.
PageLayout make_vertex_page_layout(const Page& page);

/// A value per corner. The predictors of a corner are the corners one step down along x, y and z
/// that the page has, else the corner before.
PageLayout make_corner_page_layout(const PageCorners& corners);

}  // namespace burnish

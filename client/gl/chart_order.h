#pragma once

#include <cstdint>
#include <vector>

#include "client/scene/page_texture.h"

namespace burnish {

/// Triangles of one chart that follow each other.
struct ChartRun {
  uint32_t first = 0;
  uint32_t count = 0;
  uint16_t chart = 0;

  bool operator==(const ChartRun&) const = default;
};

/// A page's triangles by patch, and within a patch by chart. So a patch is drawn in a few runs, and
/// no shader needs the number of a triangle, which OpenGL ES does not say.
struct ChartOrder {
  std::vector<uint16_t> triangles;  ///< numbers of the page's own order
  std::vector<ChartRun> runs;       ///< none crosses the end of a patch
};

ChartOrder chart_order(const PageTexture& texture);

}  // namespace burnish

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/io/textured_surface.h"

namespace burnish {

/// An edge of the surface where two charts meet.
struct SeamEdge {
  /// One of its two triangles, and its corners at the edge's ends. Both sides have the same order.
  struct Side {
    uint32_t triangle = 0;
    std::array<uint8_t, 2> corners = {0, 0};
  };
  std::array<Side, 2> sides;
};

/// The charts of a scan's pictures: triangles that hang together by corners with the same place on
/// the surface and on the same picture.
struct TextureCharts {
  /// 3 per triangle: which point of its chart a corner is; kNoTexture without a picture. Corners at
  /// one place of the surface are one point of a chart.
  std::vector<uint32_t> points;
  /// The corners of each point, 3 · triangle + corner; those of point i lie from begins[i] to
  /// begins[i + 1].
  std::vector<uint32_t> corners, begins;
  std::vector<SeamEdge> seams;  ///< edges of two triangles in different charts
  uint32_t charts = 0;

  uint32_t point_count() const { return static_cast<uint32_t>(begins.size()) - 1; }
  std::span<const uint32_t> corners_of(uint32_t point) const {
    return std::span(corners).subspan(begins[point], begins[point + 1] - begins[point]);
  }
};

/// Finds the charts of a surface with textures. Fails: as the budget does, which hears the memory
/// first.
Result<TextureCharts> find_texture_charts(const TexturedSurface& surface,
                                          const FileBudget& budget = {});

}  // namespace burnish

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/base/types.h"
#include "common/sheets/bake_sheet.h"
#include "common/sheets/push_pull.h"
#include "common/sheets/sheet_layout.h"

namespace burnish {

/// Private to this folder: draws one chart with its gutter, on a raster of samples.
class ChartBaker {
 public:
  /// `mapping`: to texels of the chart alone, gutter included; `size`: with the gutter.
  ChartBaker(const ChartMapping& mapping, const TexelSize& size, int samples_per_side);

  /// Draws needles for triangles that are too thin to hold a sample's centre.
  enum class Drawing { kTriangles, kNeedles };

  /// Draws a triangle of the page.
  void add_target(const std::array<Vec3d, 3>& corners, Drawing drawing);
  /// Returns whether no sample lies in the targets so far.
  bool is_bare() const;

  /// Continues the page's surface over the gutter. Call once, after the last add_target().
  void dilate();

  /// Draws a triangle of the source where it is nearer than those before. Needs: dilate().
  void add_source(uint32_t triangle, const std::array<Vec3d, 3>& corners, Drawing drawing);
  /// Returns whether no sample has met a source so far.
  bool is_unmet() const;

  /// Returns the texels: means of the samples that have a hit.
  TexelGrid resolve(const BakeSource& source) const;

 private:
  struct Sample {
    int x = 0;
    int y = 0;
  };

  /// The triangle that faces a sample. The third weight follows from the others.
  struct Hit {
    float distance = std::numeric_limits<float>::infinity();  ///< texels, to the page's surface
    uint32_t triangle = UINT32_MAX;
    std::array<float, 2> weights = {};
  };

  size_t at(int x, int y) const { return size_t(y) * width_ + x; }
  template <typename Visit>
  void draw(const std::array<Vec2d, 3>& corners, Drawing drawing, const Visit& visit) const;
  std::array<Vec2d, 3> flat(const std::array<Vec3d, 3>& corners) const;
  Vec3d depths_of(const std::array<Vec3d, 3>& corners) const;
  bool is_outside(const std::array<Vec2d, 3>& corners) const;
  template <typename Visit>
  void for_each_around(const Sample& sample, const Visit& visit) const;
  std::vector<Sample> widen(const std::vector<Sample>& front);
  float mean_around(const Sample& sample) const;

  const ChartMapping mapping_;
  const int samples_;
  const int width_;            // samples
  const int height_;           // samples
  std::vector<float> depths_;  // texels; NaN where the page has no surface
  std::vector<uint8_t> is_inside_;
  std::vector<Hit> hits_;
};

}  // namespace burnish

#include "common/sheets/bake_sheet.h"

#include <algorithm>
#include <cmath>

#include "common/base/groups.h"
#include "common/sheets/chart_baker.h"
#include "common/sheets/triangle_boxes.h"

namespace burnish {

namespace {

std::array<Vec3d, 3> page_corners(const Page& page, size_t triangle) {
  std::array<Vec3d, 3> corners;
  for (int k = 0; k < 3; ++k)
    corners[k] = page.positions[page.triangles[triangle][k]].cast<double>();
  return corners;
}

/// The page's triangles by their charts.
Groups<uint16_t> triangles_by_chart(const PageCharts& charts) {
  return group_by<uint16_t>(charts.charts.size(), [&](const auto& add) {
    for (size_t t = 0; t < charts.of_triangle.size(); ++t)
      add(charts.of_triangle[t], static_cast<uint16_t>(t));
  });
}

/// Bakes the charts of one sheet.
class SheetBaker {
 public:
  SheetBaker(const Page& page, const PageCharts& charts, const BakeWish& wish,
             const BakeSource& source)
      : page_(page),
        charts_(charts),
        wish_(wish),
        source_(source),
        triangles_(triangles_by_chart(charts)),
        boxes_(source.triangles) {}

  TexelGrid bake(size_t chart, const TexelSize& size) const {
    ChartBaker baker(chart_mapping(charts_.charts[chart], wish_.texels_per_step, {}), size,
                     wish_.samples_per_side);
    const Box3d box = add_targets(baker, chart, ChartBaker::Drawing::kTriangles);
    if (baker.is_bare()) add_targets(baker, chart, ChartBaker::Drawing::kNeedles);
    baker.dilate();
    const std::vector<uint32_t> sources = boxes_.near(widened(box));
    add_sources(baker, sources, ChartBaker::Drawing::kTriangles);
    if (baker.is_unmet()) add_sources(baker, sources, ChartBaker::Drawing::kNeedles);
    TexelGrid grid = baker.resolve(source_);
    push_pull(grid);
    return grid;
  }

 private:
  /// Returns the box around the chart's triangles.
  Box3d add_targets(ChartBaker& baker, size_t chart, ChartBaker::Drawing drawing) const {
    Box3d box;
    for (const uint16_t t : triangles_[chart]) {
      const std::array<Vec3d, 3> corners = page_corners(page_, t);
      baker.add_target(corners, drawing);
      for (const Vec3d& corner : corners) box.extend(corner);
    }
    return box;
  }

  void add_sources(ChartBaker& baker, const std::vector<uint32_t>& sources,
                   ChartBaker::Drawing drawing) const {
    for (const uint32_t t : sources) baker.add_source(t, source_.triangles[t], drawing);
  }

  /// Adds what a source may lie beside the page: the gutter with its reach, and the difference of
  /// two levels of a surface, which is a part of the chart's own size.
  Box3d widened(const Box3d& box) const {
    constexpr double kTexels = 16;
    constexpr double kPartOfSize = 0.25;
    const double border = kTexels / wish_.texels_per_step + kPartOfSize * box.sizes().norm();
    return {box.min() - Vec3d::Constant(border), box.max() + Vec3d::Constant(border)};
  }

  const Page& page_;
  const PageCharts& charts_;
  const BakeWish& wish_;
  const BakeSource& source_;
  const Groups<uint16_t> triangles_;  // of the page, by chart
  const TriangleBoxes boxes_;         // of the source
};

void paste(const TexelGrid& chart, const TexelPlace& place, TexelGrid& sheet) {
  for (int y = 0; y < chart.height; ++y)
    for (int x = 0; x < chart.width; ++x) {
      const size_t to = sheet.at(place.x + x, place.y + y);
      sheet.texels[to] = chart.texels[chart.at(x, y)];
      sheet.is_known[to] = chart.is_known[chart.at(x, y)];
    }
}

std::vector<Rgba8> rounded_texels(const TexelGrid& grid) {
  std::vector<Rgba8> texels(grid.texels.size(), Rgba8{0, 0, 0, 255});
  for (size_t i = 0; i < texels.size(); ++i)
    for (int channel = 0; grid.is_known[i] != 0 && channel < 4; ++channel)
      texels[i][channel] =
          static_cast<uint8_t>(std::lround(std::clamp(grid.texels[i][channel], 0.0f, 255.0f)));
  return texels;
}

}  // namespace

std::vector<Rgba8> bake_sheet(const Page& page, const PageCharts& charts, const BakeWish& wish,
                              const BakeSource& source) {
  const std::vector<TexelSize> sizes = chart_sizes(page, charts, wish.texels_per_step);
  TexelGrid sheet(wish.layout.width, wish.layout.height);
  const SheetBaker baker(page, charts, wish, source);
  for (size_t c = 0; c < sizes.size(); ++c)
    paste(baker.bake(c, sizes[c]), wish.layout.places[c], sheet);
  push_pull(sheet);
  return rounded_texels(sheet);
}

}  // namespace burnish

#include "common/sheets/bake_sheet.h"

#include <algorithm>
#include <cmath>

#include "common/sheets/chart_baker.h"

namespace burnish {

namespace {

std::array<Vec3d, 3> page_corners(const Page& page, size_t triangle) {
  std::array<Vec3d, 3> corners;
  for (int k = 0; k < 3; ++k)
    corners[k] = page.positions[page.triangles[triangle][k]].cast<double>();
  return corners;
}

TexelGrid bake_chart(const Page& page, const PageCharts& charts, size_t chart,
                     const TexelSize& size, const BakeWish& wish, const BakeSource& source) {
  ChartBaker baker(chart_mapping(charts.charts[chart], wish.texels_per_step, {}), size,
                   wish.samples_per_side);
  for (size_t t = 0; t < page.triangles.size(); ++t)
    if (charts.of_triangle[t] == chart) baker.add_target(page_corners(page, t));
  baker.dilate();
  for (size_t t = 0; t < source.triangles.size(); ++t)
    baker.add_source(static_cast<uint32_t>(t), source.triangles[t]);
  TexelGrid grid = baker.resolve(source);
  push_pull(grid);
  return grid;
}

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
  for (size_t c = 0; c < sizes.size(); ++c)
    paste(bake_chart(page, charts, c, sizes[c], wish, source), wish.layout.places[c], sheet);
  push_pull(sheet);
  return rounded_texels(sheet);
}

}  // namespace burnish

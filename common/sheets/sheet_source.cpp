#include "common/sheets/sheet_source.h"

#include <algorithm>
#include <cmath>

#include "common/sheets/catmull_rom.h"

namespace burnish {

namespace {

/// A triangle with the texels of its corners.
struct SheetedTriangle {
  const Sheet* sheet;
  std::array<Vec2d, 3> corners;
};

Texel sample_sheet(const Sheet& sheet, double x, double y) {
  const double left = std::floor(x - 0.5);
  const double top = std::floor(y - 0.5);
  const auto along_x = catmull_rom(static_cast<float>(x - 0.5 - left));
  const auto along_y = catmull_rom(static_cast<float>(y - 0.5 - top));
  const auto inside = [](double first, int k, int size) {
    return static_cast<size_t>(std::clamp(first + k - 1, 0.0, size - 1.0));
  };
  Texel sum = Texel::Zero();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const Rgba8& texel = sheet.texels[inside(top, row, sheet.layout.height) * sheet.layout.width +
                                        inside(left, column, sheet.layout.width)];
      sum += along_x[column] * along_y[row] * Texel(texel[0], texel[1], texel[2], texel[3]);
    }
  return sum.cwiseMax(0.0f).cwiseMin(255.0f);  // splines overshoot
}

void add_page(const SheetedPage& sheeted, double step, std::vector<SheetedTriangle>& triangles,
              BakeSource& source) {
  const auto& [page, charts, sheet] = sheeted;
  std::vector<ChartMapping> mappings;
  for (size_t c = 0; c < charts->charts.size(); ++c)
    mappings.push_back(
        chart_mapping(charts->charts[c], sheet->density * step, sheet->layout.places[c]));
  for (size_t t = 0; t < page->triangles.size(); ++t) {
    const ChartMapping& mapping = mappings[charts->of_triangle[t]];
    SheetedTriangle& triangle = triangles.emplace_back();
    triangle.sheet = sheet;
    auto& corners = source.triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      corners[k] = page->positions[page->triangles[t][k]].cast<double>();
      triangle.corners[k] = mapping.texel(corners[k]);
    }
  }
}

}  // namespace

BakeSource source_of_sheets(std::span<const SheetedPage> pages, double step) {
  BakeSource source;
  std::vector<SheetedTriangle> triangles;
  for (const SheetedPage& page : pages) add_page(page, step, triangles, source);
  source.texel = [triangles = std::move(triangles)](uint32_t triangle, const Vec3d& weights) {
    const auto& [sheet, corners] = triangles[triangle];
    const Vec2d at = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    return sample_sheet(*sheet, at.x(), at.y());
  };
  return source;
}

}  // namespace burnish

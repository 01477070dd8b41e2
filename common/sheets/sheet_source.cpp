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

/// Returns the numbers of four texels of a row or column; beyond the border that of its last one.
std::array<size_t, 4> texels_from(double first, int size) {
  std::array<size_t, 4> numbers;
  for (int k = 0; k < 4; ++k)
    numbers[k] = static_cast<size_t>(std::clamp(first + k, 0.0, size - 1.0));
  return numbers;
}

Texel sample_sheet(const Sheet& sheet, double x, double y) {
  const double left = std::floor(x - 0.5);
  const double top = std::floor(y - 0.5);
  const auto columns = texels_from(left - 1, sheet.layout.width);
  const auto rows = texels_from(top - 1, sheet.layout.height);
  return filtered_by_catmull_rom(
      x - 0.5 - left, y - 0.5 - top, [&](int row, int column) -> const Rgba8& {
        return sheet.texels[rows[row] * sheet.layout.width + columns[column]];
      });
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

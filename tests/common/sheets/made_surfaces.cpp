#include "tests/common/sheets/made_surfaces.h"

#include <cmath>
#include <numbers>

#include "common/sheets/triangle_raster.h"

namespace burnish {

namespace {

constexpr double kMiddle = 1 << 20;

Vec3i rounded(const Vec3d& point) {
  return {static_cast<int>(std::lround(point.x())), static_cast<int>(std::lround(point.y())),
          static_cast<int>(std::lround(point.z()))};
}

void add_square(Page& page, int a, int b, int c, int d) {
  const auto at = [](int v) { return static_cast<uint16_t>(v); };
  page.triangles.push_back({at(a), at(b), at(c)});
  page.triangles.push_back({at(c), at(b), at(d)});
}

Page finished(Page page) {
  page.patches = {{kNoPage, static_cast<uint32_t>(page.triangles.size())}};
  return page;
}

}  // namespace

Page wavy_page(int side, double spacing, double height) {
  Page page;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double u = static_cast<double>(x) / (side - 1);
      const double v = static_cast<double>(y) / (side - 1);
      const double z = std::sin(4 * std::numbers::pi * u) * std::cos(3 * std::numbers::pi * v);
      page.positions.push_back(
          rounded({kMiddle + spacing * x, kMiddle + spacing * y, kMiddle + height * z}));
    }
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const int a = y * side + x;
      add_square(page, a, a + 1, a + side, a + side + 1);
    }
  return finished(std::move(page));
}

Page sphere_page(int rings, double radius) {
  Page page;
  const int columns = 2 * rings;
  const auto point = [&](double latitude, double longitude) {
    return rounded(Vec3d::Constant(kMiddle) +
                   radius * Vec3d(std::cos(longitude) * std::sin(latitude),
                                  std::sin(longitude) * std::sin(latitude), -std::cos(latitude)));
  };
  for (int ring = 1; ring < rings; ++ring)
    for (int column = 0; column < columns; ++column)
      page.positions.push_back(
          point(std::numbers::pi * ring / rings, 2 * std::numbers::pi * column / columns));
  const int low = static_cast<int>(page.positions.size());
  page.positions.push_back(point(0, 0));
  page.positions.push_back(point(std::numbers::pi, 0));
  for (int column = 0; column < columns; ++column) {
    const int next = (column + 1) % columns;
    for (int ring = 0; ring + 2 < rings; ++ring) {
      const int row = ring * columns;
      add_square(page, row + column, row + next, row + columns + column, row + columns + next);
    }
    const int last = (rings - 2) * columns;
    const auto at = [](int v) { return static_cast<uint16_t>(v); };
    page.triangles.push_back({at(low), at(next), at(column)});
    page.triangles.push_back({at(low + 1), at(last + column), at(last + next)});
  }
  return finished(std::move(page));
}

Page ramp_page(double radius) {
  Page page;
  constexpr int kSteps = 128;
  for (int i = 0; i <= kSteps; ++i) {
    const double turn = 4 * std::numbers::pi * i / kSteps;
    const Vec3d out(std::cos(turn), std::sin(turn), 0);
    const Vec3d up = Vec3d::UnitZ() * (0.2 * radius * i / kSteps);
    page.positions.push_back(rounded(Vec3d::Constant(kMiddle) + 0.5 * radius * out + up));
    page.positions.push_back(rounded(Vec3d::Constant(kMiddle) + radius * out + up));
  }
  for (int i = 0; i < kSteps; ++i) add_square(page, 2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 3);
  return finished(std::move(page));
}

Page torn_page(const Page& page) {
  Page torn{.patches = page.patches};
  for (const PageTriangle& triangle : page.triangles) {
    const auto first = static_cast<uint16_t>(torn.positions.size());
    for (const uint16_t vertex : triangle) torn.positions.push_back(page.positions[vertex]);
    torn.triangles.push_back(
        {first, static_cast<uint16_t>(first + 1), static_cast<uint16_t>(first + 2)});
  }
  return torn;
}

double area_of(const Page& page) {
  double area = 0;
  for (const PageTriangle& triangle : page.triangles) {
    const Vec3d a = page.positions[triangle[0]].cast<double>();
    const Vec3d b = page.positions[triangle[1]].cast<double>();
    const Vec3d c = page.positions[triangle[2]].cast<double>();
    area += (b - a).cross(c - a).norm() / 2;
  }
  return area;
}

size_t covered_twice(const Page& page, const PageCharts& charts, double texels_per_step) {
  const std::vector<ChartExtent> extents = chart_extents(page, charts);
  size_t twice = 0;
  for (size_t c = 0; c < charts.charts.size(); ++c) {
    const ChartAxes axes = axes_of(charts.charts[c]);
    const int width = static_cast<int>(std::ceil(extents[c].u * texels_per_step)) + 1;
    const int height = static_cast<int>(std::ceil(extents[c].v * texels_per_step)) + 1;
    std::vector<int> covers(size_t(width) * height, 0);
    for (size_t t = 0; t < page.triangles.size(); ++t) {
      if (charts.of_triangle[t] != c) continue;
      std::array<Vec2d, 3> corners;
      for (int k = 0; k < 3; ++k) {
        const Vec3d p = page.positions[page.triangles[t][k]].cast<double>();
        const auto& least = charts.charts[c].least;
        corners[k] = Vec2d(axes.u.dot(p) - least[0], axes.v.dot(p) - least[1]) * texels_per_step +
                     Vec2d::Constant(0.5);
      }
      draw_triangle(corners, width, height, [&](int x, int y, const Vec3d&) {
        if (++covers[size_t(y) * width + x] == 2) ++twice;
      });
    }
  }
  return twice;
}

}  // namespace burnish

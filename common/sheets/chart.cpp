#include "common/sheets/chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "common/pages/octahedral.h"

namespace burnish {

namespace {

/// Calls visit(chart, vertex) for each corner of each triangle.
template <typename Visit>
void for_each_corner(const Page& page, const PageCharts& charts, Visit&& visit) {
  for (size_t t = 0; t < page.triangles.size(); ++t)
    for (const uint16_t vertex : page.triangles[t]) visit(charts.of_triangle[t], vertex);
}

Vec3d corner_place(const Page& page, uint16_t vertex) {
  return page.positions[vertex].cast<double>();
}

Status check_numbers(const PageCharts& charts) {
  size_t next = 0;
  for (size_t t = 0; t < charts.of_triangle.size(); ++t) {
    const size_t chart = charts.of_triangle[t];
    if (chart > next || chart >= charts.charts.size())
      return invalid_argument("triangle " + std::to_string(t) + " is in chart " +
                              std::to_string(chart) + ", the limit is " +
                              std::to_string(std::min(next, charts.charts.size() - 1)));
    next = std::max(next, chart + 1);
  }
  if (next == charts.charts.size()) return Status::ok();
  return invalid_argument("chart " + std::to_string(next) + " of " +
                          std::to_string(charts.charts.size()) + " has no triangle");
}

}  // namespace

ChartAxes axes_of(const Chart& chart) {
  const Vec3d n = octahedral_normal({chart.normal[0], chart.normal[1]}, kChartNormalLimit)
                      .cast<double>()
                      .normalized();
  const double sign = std::copysign(1.0, n.z());
  const double a = -1 / (sign + n.z());
  const double b = n.x() * n.y() * a;
  const Vec3d first(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
  const Vec3d second(b, sign + n.y() * n.y() * a, -n.y());
  const double turn = chart.angle * (2 * std::numbers::pi / 65536);
  return {std::cos(turn) * first + std::sin(turn) * second,
          std::cos(turn) * second - std::sin(turn) * first, n};
}

std::vector<ChartExtent> chart_extents(const Page& page, const PageCharts& charts) {
  std::vector<ChartAxes> axes;
  for (const Chart& chart : charts.charts) axes.push_back(axes_of(chart));
  std::vector<ChartExtent> extents(charts.charts.size());
  for_each_corner(page, charts, [&](uint16_t c, uint16_t vertex) {
    const Vec3d p = corner_place(page, vertex);
    const auto& least = charts.charts[c].least;
    extents[c].u = std::max(extents[c].u, axes[c].u.dot(p) - least[0]);
    extents[c].v = std::max(extents[c].v, axes[c].v.dot(p) - least[1]);
  });
  return extents;
}

Status check_charts(const Page& page, const PageCharts& charts) {
  const size_t triangles = page.triangles.size();
  if (charts.charts.empty() || charts.charts.size() > triangles)
    return invalid_argument(std::to_string(charts.charts.size()) + " charts are outside 1.." +
                            std::to_string(triangles));
  if (charts.of_triangle.size() != triangles)
    return invalid_argument(std::to_string(charts.of_triangle.size()) +
                            " triangles have charts, the page has " + std::to_string(triangles));
  RETURN_IF_ERROR(check_numbers(charts));
  std::vector<ChartAxes> axes;
  for (const Chart& chart : charts.charts) axes.push_back(axes_of(chart));
  Status status = Status::ok();
  for_each_corner(page, charts, [&](uint16_t c, uint16_t vertex) {
    const Vec3d p = corner_place(page, vertex);
    const auto& least = charts.charts[c].least;
    if (axes[c].u.dot(p) >= least[0] && axes[c].v.dot(p) >= least[1]) return;
    status = invalid_argument("chart " + std::to_string(c) + " begins at " +
                              std::to_string(least[0]) + ", " + std::to_string(least[1]) +
                              ", after vertex " + std::to_string(vertex));
  });
  return status;
}

}  // namespace burnish

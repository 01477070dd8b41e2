#include "common/sheets/cut_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/pages/octahedral.h"
#include "common/sheets/grow_charts.h"
#include "common/sheets/sheet_limits.h"
#include "common/sheets/triangle_raster.h"

namespace burnish {

namespace {

constexpr int kAngles = 12;         // of a quarter turn: a rectangle looks the same after one
constexpr double kQuarter = 16384;  // of Chart::angle

/// A rectangle along a chart's axes, steps.
struct PlaneBox {
  Vec2d least = Vec2d::Constant(std::numeric_limits<double>::infinity());
  Vec2d most = -least;

  void add(const Vec2d& point) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  Vec2d size() const { return most - least; }
};

/// Fits charts to a page's texels.
class ChartCutter {
 public:
  ChartCutter(const Page& page, double texels_per_step)
      : page_(page), texels_per_step_(texels_per_step) {}

  /// Places a chart, or cuts it into parts that are placed instead.
  void place(GrownChart grown) {
    std::vector<GrownChart> waiting;
    waiting.push_back(std::move(grown));
    while (!waiting.empty()) {
      const GrownChart chart = std::move(waiting.back());
      waiting.pop_back();
      place_or_cut(chart, waiting);
    }
  }

  /// Numbers the charts by their first triangles.
  PageCharts finish() {
    std::ranges::sort(placed_, {}, [](const Placed& placed) { return placed.triangles.front(); });
    PageCharts charts;
    charts.of_triangle.resize(page_.triangles.size());
    for (const Placed& placed : placed_) {
      for (const uint16_t t : placed.triangles)
        charts.of_triangle[t] = static_cast<uint16_t>(charts.charts.size());
      charts.charts.push_back(placed.chart);
    }
    return charts;
  }

 private:
  struct Placed {
    Chart chart;
    std::vector<uint16_t> triangles;  // rising
  };

  std::array<Vec2d, 3> corners(uint16_t triangle, const ChartAxes& axes) const {
    std::array<Vec2d, 3> flat;
    for (int k = 0; k < 3; ++k) {
      const Vec3d p = page_.positions[page_.triangles[triangle][k]].cast<double>();
      flat[k] = {axes.u.dot(p), axes.v.dot(p)};
    }
    return flat;
  }

  PlaneBox box_of(const GrownChart& grown, const ChartAxes& axes) const {
    PlaneBox box;
    for (const uint16_t t : grown.triangles)
      for (const Vec2d& corner : corners(t, axes)) box.add(corner);
    return box;
  }

  /// Takes the angle of the smallest rectangle.
  Chart fit(const GrownChart& grown) const {
    const OctahedralCode code = octahedral_code(grown.axis.cast<float>(), kChartNormalLimit);
    Chart best;
    double least_area = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kAngles; ++k) {
      Chart chart{.normal = {static_cast<int16_t>(code[0]), static_cast<int16_t>(code[1])},
                  .angle = static_cast<uint16_t>(std::lround(k * kQuarter / kAngles))};
      const PlaneBox box = box_of(grown, axes_of(chart));
      const double area = (box.size() + Vec2d::Ones()).prod();  // a line has a length too
      if (area >= least_area) continue;
      least_area = area;
      best = chart;
      for (int axis = 0; axis < 2; ++axis)
        best.least[axis] = static_cast<int32_t>(std::floor(box.least[axis]));
    }
    return best;
  }

  void place_or_cut(const GrownChart& grown, std::vector<GrownChart>& waiting) {
    const Chart chart = fit(grown);
    const ChartAxes axes = axes_of(chart);
    const Vec2d origin(chart.least[0], chart.least[1]);
    const Vec2d texels = (box_of(grown, axes).most - origin) * texels_per_step_;
    const bool is_alone = grown.triangles.size() == 1;
    if (!is_alone && texels.maxCoeff() > kChartTexelsMax)
      return halve(grown, texels.x() >= texels.y() ? axes.u : axes.v, waiting);
    if (!is_alone && split_covering(grown, axes, origin, texels, waiting)) return;
    placed_.push_back({chart, grown.triangles});
    std::ranges::sort(placed_.back().triangles);
  }

  /// Cuts across a direction, so that both parts have as many triangles.
  void halve(const GrownChart& grown, const Vec3d& along, std::vector<GrownChart>& waiting) const {
    const auto place = [&](uint16_t t) {
      Vec3i sum = Vec3i::Zero();
      for (const uint16_t vertex : page_.triangles[t]) sum += page_.positions[vertex];
      return along.dot(sum.cast<double>());
    };
    std::vector<uint16_t> sorted = grown.triangles;
    std::ranges::stable_sort(sorted, {}, place);
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    waiting.push_back({{sorted.begin(), middle}, grown.axis});
    waiting.push_back({{middle, sorted.end()}, grown.axis});
  }

  /// Takes apart the triangles that cover texels of those before. Returns whether there are any.
  bool split_covering(const GrownChart& grown, const ChartAxes& axes, const Vec2d& origin,
                      const Vec2d& texels, std::vector<GrownChart>& waiting) const {
    const int width = static_cast<int>(std::ceil(texels.x())) + 1;
    const int height = static_cast<int>(std::ceil(texels.y())) + 1;
    std::vector<uint8_t> is_covered(size_t(width) * height, 0);
    GrownChart below{{}, grown.axis};
    GrownChart above{{}, grown.axis};
    std::vector<size_t> texels_of;
    for (const uint16_t t : grown.triangles) {
      std::array<Vec2d, 3> flat = corners(t, axes);
      for (Vec2d& corner : flat)
        corner = (corner - origin) * texels_per_step_ + Vec2d::Constant(0.5);
      texels_of.clear();
      draw_triangle(flat, width, height, [&](int x, int y, const Vec3d&) {
        texels_of.push_back(size_t(y) * width + x);
      });
      const bool covers =
          std::ranges::any_of(texels_of, [&](size_t texel) { return is_covered[texel] != 0; });
      (covers ? above : below).triangles.push_back(t);
      if (!covers)
        for (const size_t texel : texels_of) is_covered[texel] = 1;
    }
    if (above.triangles.empty()) return false;
    waiting.push_back(std::move(above));
    waiting.push_back(std::move(below));
    return true;
  }

  const Page& page_;
  const double texels_per_step_;
  std::vector<Placed> placed_;
};

}  // namespace

PageCharts cut_charts(const Page& page, double texels_per_step) {
  ChartCutter cutter(page, texels_per_step);
  for (GrownChart& grown : grow_charts(facet_graph(page))) cutter.place(std::move(grown));
  return cutter.finish();
}

}  // namespace burnish

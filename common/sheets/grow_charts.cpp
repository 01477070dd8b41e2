#include "common/sheets/grow_charts.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace burnish {

namespace {

// Cosines between a triangle's normal and the axis of its chart.
constexpr double kGrowFacing = 0.62;  // to be taken
constexpr double kKeepFacing = 0.35;  // to stay once the axis has moved
constexpr double kJoinFacing = 0.3;   // for a small chart to go to a neighbour
constexpr size_t kSmallChart = 12;    // triangles; fewer cost more in gutter than in angle

constexpr int kNoChart = -1;

class ChartGrower {
 public:
  explicit ChartGrower(const FacetGraph& graph)
      : graph_(graph), chart_of_(graph.normals.size(), kNoChart) {}

  std::vector<GrownChart> grow() {
    const std::vector<uint16_t> seeds = seeds_by_area();
    size_t placed = 0;
    while (placed < seeds.size())
      for (const uint16_t seed : seeds)
        if (chart_of_[seed] == kNoChart) placed += grow_from(seed);
    for (size_t chart = 0; chart < charts_.size(); ++chart)
      if (charts_[chart].triangles.size() < kSmallChart) join_neighbour(static_cast<int>(chart));
    std::erase_if(charts_, [](const GrownChart& chart) { return chart.triangles.empty(); });
    return std::move(charts_);
  }

 private:
  std::vector<uint16_t> seeds_by_area() const {
    std::vector<uint16_t> seeds(graph_.normals.size());
    std::iota(seeds.begin(), seeds.end(), uint16_t{0});
    std::ranges::stable_sort(seeds, std::greater{},
                             [this](uint16_t t) { return graph_.area_vectors[t].squaredNorm(); });
    return seeds;
  }

  /// A triangle without an area faces all directions.
  double facing(uint16_t triangle, const Vec3d& axis) const {
    const Vec3d& normal = graph_.normals[triangle];
    return normal.isZero(0) ? 1 : normal.dot(axis);
  }

  static Vec3d axis_along(const Vec3d& sum) {
    const double length = sum.norm();
    return length > 0 ? Vec3d(sum / length) : Vec3d(Vec3d::UnitZ());
  }

  /// Returns how many triangles the new chart keeps, at least one.
  size_t grow_from(uint16_t seed) {
    const auto number = static_cast<int>(charts_.size());
    GrownChart& chart = charts_.emplace_back();
    Vec3d sum = graph_.area_vectors[seed];
    chart.axis = axis_along(sum);
    chart.triangles = {seed};
    chart_of_[seed] = number;
    for (size_t i = 0; i < chart.triangles.size(); ++i)
      for (const uint16_t next : graph_.neighbours[chart.triangles[i]]) {
        if (chart_of_[next] != kNoChart || facing(next, chart.axis) <= kGrowFacing) continue;
        chart_of_[next] = number;
        chart.triangles.push_back(next);
        sum += graph_.area_vectors[next];
        chart.axis = axis_along(sum);
      }
    while (evict(chart)) {
    }
    return chart.triangles.size();
  }

  /// Frees triangles that face away, and takes the mean of the others. Keeps the best in any case.
  bool evict(GrownChart& chart) {
    double best = -1;
    for (const uint16_t t : chart.triangles) best = std::max(best, facing(t, chart.axis));
    const double least = std::min(kKeepFacing, best);
    Vec3d sum = Vec3d::Zero();
    const size_t evicted = std::erase_if(chart.triangles, [&](uint16_t t) {
      const bool stays = facing(t, chart.axis) >= least;
      if (stays)
        sum += graph_.area_vectors[t];
      else
        chart_of_[t] = kNoChart;
      return !stays;
    });
    if (evicted > 0) chart.axis = axis_along(sum);
    return evicted > 0;
  }

  /// Moves all triangles to the neighbour with most sides in common of those that they all face.
  void join_neighbour(int small) {
    GrownChart& chart = charts_[small];
    std::map<int, size_t> sides;
    for (const uint16_t t : chart.triangles)
      for (const uint16_t next : graph_.neighbours[t])
        if (chart_of_[next] != small) ++sides[chart_of_[next]];
    int best = kNoChart;
    for (const auto& [other, count] : sides)
      if (all_face(chart, charts_[other].axis) && (best == kNoChart || count > sides[best]))
        best = other;
    if (best == kNoChart) return;
    for (const uint16_t t : chart.triangles) {
      chart_of_[t] = best;
      charts_[best].triangles.push_back(t);
    }
    chart.triangles.clear();
  }

  bool all_face(const GrownChart& chart, const Vec3d& axis) const {
    return std::ranges::all_of(chart.triangles,
                               [&](uint16_t t) { return facing(t, axis) > kJoinFacing; });
  }

  const FacetGraph& graph_;
  std::vector<int> chart_of_;
  std::vector<GrownChart> charts_;
};

}  // namespace

std::vector<GrownChart> grow_charts(const FacetGraph& graph) {
  return ChartGrower(graph).grow();
}

}  // namespace burnish

#include "server/prepare/histogram.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace burnish {

static constexpr double kFractionInRange = 0.995;

static double total_area(std::span<const CellCurvature> curvature) {
  double total = 0;
  for (const CellCurvature& cell : curvature) total += 2.0 * cell.area;
  return total;
}

static float range_of(std::span<const CellCurvature> curvature) {
  std::vector<std::pair<float, float>> magnitude_area;
  magnitude_area.reserve(2 * curvature.size());
  for (const CellCurvature& cell : curvature) {
    magnitude_area.emplace_back(std::abs(cell.kappa1), cell.area);
    magnitude_area.emplace_back(std::abs(cell.kappa2), cell.area);
  }
  std::sort(magnitude_area.begin(), magnitude_area.end());
  double left = kFractionInRange * total_area(curvature);
  for (const auto& [magnitude, area] : magnitude_area) {
    left -= area;
    if (left <= 0) return std::max(magnitude, 1.0f);
  }
  return 1;
}

CurvatureHistogram make_histogram(std::span<const CellCurvature> curvature) {
  CurvatureHistogram histogram;
  histogram.range = range_of(curvature);
  const double end = std::asinh(histogram.range);
  const double total = total_area(curvature);
  const auto add = [&](float kappa, float area) {
    const double at = (std::asinh(kappa) / end + 1) / 2 * CurvatureHistogram::kBins;
    const int bin = static_cast<int>(std::clamp(at, 0.0, CurvatureHistogram::kBins - 1.0));
    histogram.area[bin] += static_cast<float>(area / total);
  };
  for (const CellCurvature& cell : curvature) {
    add(cell.kappa1, cell.area);
    add(cell.kappa2, cell.area);
  }
  return histogram;
}

}  // namespace burnish

#include "server/prepare/histogram.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/scratch_array.h"

namespace burnish {

static constexpr double kFractionInRange = 0.995;

static double total_area(std::span<const CellCurvature> curvature) {
  double total = 0;
  for (const CellCurvature& cell : curvature) total += 2.0 * cell.area;
  return total;
}

static float range_of(std::span<const CellCurvature> curvature, const ScratchSpace& space) {
  ScratchArray<std::pair<float, float>> magnitude_area(space, 2 * curvature.size());
  for (size_t c = 0; c < curvature.size(); ++c) {
    magnitude_area[2 * c] = {std::abs(curvature[c].kappa1), curvature[c].area};
    magnitude_area[2 * c + 1] = {std::abs(curvature[c].kappa2), curvature[c].area};
  }
  // Halves the candidates until the value is found.
  auto begin = magnitude_area.begin(), end = magnitude_area.end();
  double left = kFractionInRange * total_area(curvature);
  while (end - begin > 1) {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    double below = 0;
    for (auto at = begin; at != middle; ++at) below += at->second;
    if (below >= left) {
      end = middle;
    } else {
      left -= below;
      begin = middle;
    }
  }
  return begin == end ? 1 : std::max(begin->first, 1.0f);
}

CurvatureHistogram make_histogram(std::span<const CellCurvature> curvature,
                                  const ScratchSpace& space, const LoopPart& part) {
  CurvatureHistogram histogram;
  histogram.range = range_of(curvature, space);
  const double end = std::asinh(histogram.range);
  const double total = total_area(curvature);
  const auto add = [&](float kappa, float area) {
    const double at = (std::asinh(kappa) / end + 1) / 2 * CurvatureHistogram::kBins;
    const int bin = static_cast<int>(std::clamp(at, 0.0, CurvatureHistogram::kBins - 1.0));
    histogram.area[bin] += static_cast<float>(area / total);
  };
  for_each_heard(part, curvature.size(), [&](size_t c) {
    add(curvature[c].kappa1, curvature[c].area);
    add(curvature[c].kappa2, curvature[c].area);
  });
  return histogram;
}

}  // namespace burnish

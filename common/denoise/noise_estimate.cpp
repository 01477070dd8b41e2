#include "common/denoise/noise_estimate.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace burnish {
namespace {

constexpr size_t kFanMin = 3;  // fewer triangles foretell no place
// The residual of independent noise of deviation 1 where six triangles meet: the root of the sum of
// squares of the weights of (1 - mean around) applied twice.
constexpr double kWhiteGain = 1.359;
constexpr double kQuarter = 0.3186;  // of magnitudes of a normal distribution are below this

/// Returns the mean of value(q) over the corners q of the triangles at a place, without its own.
template <typename Value>
auto mean_around(const WeldedSurface& surface, size_t place, const Value& value) {
  const auto fan = surface.fan(place);
  decltype(value(0)) sum = 0 * value(static_cast<uint32_t>(place));
  for (const uint32_t t : fan)
    for (const uint32_t corner : surface.triangle(t))
      if (corner != place) sum += value(corner);
  return decltype(sum)(sum / static_cast<double>(2 * fan.size()));
}

bool is_foretold(const WeldedSurface& surface, size_t place) {
  return surface.fan(place).size() >= kFanMin;
}

/// Returns how far each place is above the mean of those around, along its normal; 0 for vertices
/// that are no place.
std::vector<double> heights(const WeldedSurface& surface, const LoopPart& part) {
  std::vector<double> above(surface.vertex_count(), 0);
  parallel_for_heard(part, above.size(), [&](size_t place) {
    if (!is_foretold(surface, place)) return;
    Vec3d normal = Vec3d::Zero();
    for (const uint32_t t : surface.fan(place)) {
      const auto [a, b, c] = corners_of(surface.mesh(), t);
      normal += (b - a).cross(c - a);
    }
    const double length = normal.norm();
    if (!(length > 0)) return;
    const auto at = [&](uint32_t v) -> Vec3d { return surface.mesh().vertices[v]; };
    const Vec3d mean = mean_around(surface, place, at);
    above[place] = (at(static_cast<uint32_t>(place)) - mean).dot(normal) / length;
  });
  return above;
}

}  // namespace

double noise_deviation(const WeldedSurface& surface, const LoopPart& part) {
  const std::vector<double> above = heights(surface, part.of(0, 0.5));
  std::vector<double> residuals(above.size(), 0);
  const auto height = [&](uint32_t v) { return above[v]; };
  parallel_for_heard(part.of(0.5, 1), above.size(), [&](size_t place) {
    if (!is_foretold(surface, place)) return;
    residuals[place] = std::abs(above[place] - mean_around(surface, place, height));
  });
  std::vector<double> known;
  for (size_t place = 0; place < residuals.size(); ++place)
    if (is_foretold(surface, place)) known.push_back(residuals[place]);
  if (known.empty()) return 0;
  const auto quarter = known.begin() + static_cast<ptrdiff_t>(known.size() / 4);
  std::nth_element(known.begin(), quarter, known.end());
  return *quarter / (kQuarter * kWhiteGain);
}

}  // namespace burnish

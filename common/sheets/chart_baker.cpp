#include "common/sheets/chart_baker.h"

#include <algorithm>
#include <cmath>

#include "common/sheets/sheet_limits.h"
#include "common/sheets/triangle_raster.h"

namespace burnish {

namespace {

constexpr float kGutterReach = 6;  // texels; a border at 55 degrees climbs that high in the gutter
constexpr float kNoDepth = std::numeric_limits<float>::quiet_NaN();
constexpr float kDepthToCome = std::numeric_limits<float>::infinity();

}  // namespace

ChartBaker::ChartBaker(const ChartMapping& mapping, const TexelSize& size, int samples_per_side)
    : mapping_(mapping),
      samples_(samples_per_side),
      width_(static_cast<int>(size.width) * samples_),
      height_(static_cast<int>(size.height) * samples_),
      depths_(size_t(width_) * height_, kNoDepth),
      hits_(depths_.size()) {}

template <typename Visit>
void ChartBaker::draw(const std::array<Vec2d, 3>& corners, Drawing drawing,
                      const Visit& visit) const {
  if (drawing == Drawing::kNeedles)
    draw_needle(corners, width_, height_, visit);
  else
    draw_triangle(corners, width_, height_, visit);
}

void ChartBaker::add_target(const std::array<Vec3d, 3>& corners, Drawing drawing) {
  const Vec3d depths = depths_of(corners);
  draw(flat(corners), drawing, [&](int x, int y, const Vec3d& weights) {
    depths_[at(x, y)] = static_cast<float>(weights.dot(depths));
  });
}

bool ChartBaker::is_bare() const {
  return std::ranges::all_of(depths_, [](float depth) { return std::isnan(depth); });
}

bool ChartBaker::is_unmet() const {
  return std::ranges::all_of(hits_, [](const Hit& hit) { return hit.triangle == UINT32_MAX; });
}

void ChartBaker::dilate() {
  is_inside_.resize(depths_.size());
  std::vector<Sample> front;
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      is_inside_[at(x, y)] = std::isnan(depths_[at(x, y)]) ? 0 : 1;
      if (is_inside_[at(x, y)] != 0) front.push_back({x, y});
    }
  for (int pass = 0; pass < kSheetGutter * samples_; ++pass) front = widen(front);
}

/// Gives depths to the samples around those that got theirs last. Returns them.
std::vector<ChartBaker::Sample> ChartBaker::widen(const std::vector<Sample>& front) {
  std::vector<Sample> wider;
  std::vector<float> depths;
  for (const Sample& known : front)
    for_each_around(known, [&](const Sample& sample) {
      float& depth = depths_[at(sample.x, sample.y)];
      if (!std::isnan(depth)) return;
      depth = kDepthToCome;
      wider.push_back(sample);
    });
  for (const Sample& sample : wider) depths.push_back(mean_around(sample));
  for (size_t i = 0; i < wider.size(); ++i) depths_[at(wider[i].x, wider[i].y)] = depths[i];
  return wider;
}

void ChartBaker::add_source(uint32_t triangle, const std::array<Vec3d, 3>& corners,
                            Drawing drawing) {
  const std::array<Vec2d, 3> on_raster = flat(corners);
  if (is_outside(on_raster)) return;
  const Vec3d depths = depths_of(corners);
  draw(on_raster, drawing, [&](int x, int y, const Vec3d& weights) {
    const size_t i = at(x, y);
    const float distance = std::abs(static_cast<float>(weights.dot(depths)) - depths_[i]);
    if (!(distance < hits_[i].distance)) return;  // true for NaN
    if (is_inside_[i] == 0 && distance > kGutterReach) return;
    hits_[i] = {
        distance, triangle, {static_cast<float>(weights[0]), static_cast<float>(weights[1])}};
  });
}

TexelGrid ChartBaker::resolve(const BakeSource& source) const {
  TexelGrid grid(width_ / samples_, height_ / samples_);
  std::vector<float> counts(grid.texels.size(), 0);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      const Hit& hit = hits_[at(x, y)];
      if (hit.triangle == UINT32_MAX) continue;
      const double a = hit.weights[0];
      const double b = hit.weights[1];
      const size_t texel = grid.at(x / samples_, y / samples_);
      grid.texels[texel] += source.texel(hit.triangle, {a, b, 1 - a - b});
      ++counts[texel];
    }
  for (size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    grid.texels[i] /= counts[i];
    grid.is_known[i] = 1;
  }
  return grid;
}

std::array<Vec2d, 3> ChartBaker::flat(const std::array<Vec3d, 3>& corners) const {
  std::array<Vec2d, 3> on_raster;
  for (int k = 0; k < 3; ++k) on_raster[k] = mapping_.texel(corners[k]) * samples_;
  return on_raster;
}

Vec3d ChartBaker::depths_of(const std::array<Vec3d, 3>& corners) const {
  return {mapping_.normal.dot(corners[0]), mapping_.normal.dot(corners[1]),
          mapping_.normal.dot(corners[2])};
}

bool ChartBaker::is_outside(const std::array<Vec2d, 3>& corners) const {
  const Vec2d least = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Vec2d most = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  return most.x() < 0 || most.y() < 0 || least.x() > width_ || least.y() > height_;
}

template <typename Visit>
void ChartBaker::for_each_around(const Sample& sample, const Visit& visit) const {
  for (int y = std::max(0, sample.y - 1); y < std::min(height_, sample.y + 2); ++y)
    for (int x = std::max(0, sample.x - 1); x < std::min(width_, sample.x + 2); ++x) visit({x, y});
}

float ChartBaker::mean_around(const Sample& sample) const {
  float sum = 0;
  int count = 0;
  for_each_around(sample, [&](const Sample& near) {
    const float depth = depths_[at(near.x, near.y)];
    if (!std::isfinite(depth)) return;
    sum += depth;
    ++count;
  });
  return sum / static_cast<float>(count);  // one at least
}

}  // namespace burnish

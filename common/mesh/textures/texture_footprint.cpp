#include "common/mesh/textures/texture_footprint.h"

#include <algorithm>
#include <cmath>

namespace burnish {

/// Returns the row of the picture at a row of the endless texture.
static uint32_t folded_row(double row, double height, TextureWrap wrap) {
  if (wrap == TextureWrap::kClamp) return static_cast<uint32_t>(std::clamp(row, 0.0, height - 1));
  const double turns = std::floor(row / height);
  const double rest = std::clamp(row - turns * height, 0.0, height - 1);
  const bool is_mirrored = wrap == TextureWrap::kMirror && std::fmod(turns, 2) != 0;
  return static_cast<uint32_t>(is_mirrored ? height - 1 - rest : rest);
}

TextureFootprint::TextureFootprint(const std::array<Eigen::Vector2d, 3>& corners, uint32_t height,
                                   const TextureWraps& wraps)
    : height_(height), wraps_(wraps) {
  for (size_t k = 0; k < 3; ++k) {
    x_[k] = corners[k].x();
    y_[k] = corners[k].y();
  }
  const auto [lowest, highest] = std::ranges::minmax(y_);
  const double range_max = is_clamped() ? HUGE_VAL : kRepetitionsMax * period();
  const double shrink = std::min(1.0, range_max / (highest - lowest));
  const double base = is_clamped() ? 0 : period() * std::floor(lowest / period());
  constexpr double kLeastStep = 5e-4;  // a level line of a triangle has no order from below
  const bool is_level = highest - lowest < 2 * kLeastStep;
  for (size_t k = 0; k < 3; ++k)
    y_[k] = lowest - base +
            (is_level ? kLeastStep * static_cast<double>(k) : shrink * (y_[k] - lowest));
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::sort(order, {}, [&](int k) { return y_[static_cast<size_t>(k)]; });
  low_ = order[0];
  middle_ = order[1];
  high_ = order[2];
  bends_ = {y_[middle_], (y_[0] + y_[1] + y_[2]) / 3, (y_[0] + y_[1]) / 2, (y_[1] + y_[2]) / 2,
            (y_[2] + y_[0]) / 2};
  std::ranges::sort(bends_);
}

std::vector<TexelRows> TextureFootprint::rows() const {
  const double first = std::floor(y_[low_] - 0.5), last = std::floor(y_[high_] - 0.5) + 1;
  const double turn = std::floor(first / height_), turns = std::floor(last / height_) - turn;
  const uint32_t a = folded_row(first, height_, wraps_.v), b = folded_row(last, height_, wraps_.v);
  const uint32_t end = height_ - 1;
  if (is_clamped() || turns == 0) return {{std::min(a, b), std::max(a, b)}};
  if (turns > 1) return {{0, end}};
  if (wraps_.v == TextureWrap::kRepeat) {
    if (b + 1 >= a) return {{0, end}};
    return {{0, b}, {a, end}};
  }
  const bool turns_at_end = std::fmod(turn, 2) == 0;
  if (turns_at_end) return {{std::min(a, b), end}};
  return {{0, std::max(a, b)}};
}

double TextureFootprint::row_count() const {
  if (!is_clamped()) return height() + 1;
  const TexelRows range = rows()[0];
  return range.last - range.first + 1.0;
}

std::array<TextureFootprint::Barycentric, 2> TextureFootprint::ends_of_line(double y) const {
  Barycentric from = {}, to = {};
  const double along = (y - y_[low_]) / (y_[high_] - y_[low_]);
  from[low_] = 1 - along;
  from[high_] = along;
  const bool is_below = y < y_[middle_];
  const int side = is_below ? low_ : high_;
  const double part = (y - y_[side]) / (y_[middle_] - y_[side]);
  to[middle_] = y_[middle_] == y_[side] ? 1 : part;
  to[side] = 1 - to[middle_];
  return {from, to};
}

std::array<double, 2> TextureFootprint::part_of_third(const Barycentric& from,
                                                      const Barycentric& to, int corner) {
  double begin = 0, end = 1;
  for (int other = 0; other < 3; ++other) {
    if (other == corner) continue;
    const double at_begin = from[corner] - from[other], at_end = to[corner] - to[other];
    if (at_begin < 0 && at_end < 0) return {0, 0};
    if (at_begin >= 0 && at_end >= 0) continue;
    const double zero = at_begin / (at_begin - at_end);
    if (at_begin < 0) begin = std::max(begin, zero);
    if (at_end < 0) end = std::min(end, zero);
  }
  return {begin, end};
}

double TextureFootprint::x_between(const Barycentric& from, const Barycentric& to,
                                   double at) const {
  double x = 0;
  for (int corner = 0; corner < 3; ++corner)
    x += x_[corner] * (from[corner] + at * (to[corner] - from[corner]));
  return x;
}

}  // namespace burnish

#include "common/mesh/textures/texture_row.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/mesh/srgb.h"

namespace burnish {

static const std::array<float, 256>& linear_bytes() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> linear;
    for (size_t byte = 0; byte < linear.size(); ++byte)
      linear[byte] = linear_of_srgb(static_cast<uint8_t>(byte));
    return linear;
  }();
  return table;
}

TextureRow::TextureRow(uint32_t width) : pixels_(width), sums_(width) {}

void TextureRow::set(const PixelRun& run) {
  const std::array<float, 256>& linear = linear_bytes();
  if (run.pixels.size() != pixels_.size())
    std::ranges::fill(pixels_, Eigen::Array4f(Eigen::Array4f::Zero()));
  size_t at = run.first;
  for (const Rgba8& pixel : run.pixels) {
    pixels_[at] = {linear[pixel[0]], linear[pixel[1]], linear[pixel[2]], 1};
    at += run.step;
  }
  sums_[0].setZero();
  for (size_t i = 1; i < pixels_.size(); ++i)
    sums_[i] = sums_[i - 1] + 0.5 * (pixels_[i - 1] + pixels_[i]).cast<double>();
}

/// Returns the pixel that follows the last one, or that precedes the first one.
const Eigen::Array4f& TextureRow::beyond(bool is_right, TextureWrap wrap) const {
  const bool is_last = is_right != (wrap == TextureWrap::kRepeat);
  return is_last ? pixels_.back() : pixels_.front();
}

/// Integrates from the first pixel's centre. Needs: 0 <= x <= width.
Eigen::Array4d TextureRow::integral_from_first(double x, TextureWrap wrap) const {
  const double z = x - 0.5;
  if (z < 0) {
    const Eigen::Array4d first = pixels_.front().cast<double>();
    return z * first - z * z / 2 * (beyond(false, wrap).cast<double>() - first);
  }
  const size_t i = std::min(static_cast<size_t>(z), pixels_.size() - 1);
  const double t = z - static_cast<double>(i);
  const Eigen::Array4f& next = i + 1 < pixels_.size() ? pixels_[i + 1] : beyond(true, wrap);
  const Eigen::Array4d here = pixels_[i].cast<double>();
  return sums_[i] + t * here + t * t / 2 * (next.cast<double>() - here);
}

/// Integrates from the left border. Needs: 0 <= x <= width.
Eigen::Array4d TextureRow::integral_inside(double x, TextureWrap wrap) const {
  return integral_from_first(x, wrap) - integral_from_first(0, wrap);
}

Eigen::Array4d TextureRow::integral(double x, TextureWrap wrap) const {
  const auto width = static_cast<double>(pixels_.size());
  if (wrap == TextureWrap::kClamp) {
    if (x < 0) return x * pixels_.front().cast<double>();
    if (x <= width) return integral_inside(x, wrap);
    return integral_inside(width, wrap) + (x - width) * pixels_.back().cast<double>();
  }
  const double turns = std::floor(x / width);
  const double rest = std::clamp(x - turns * width, 0.0, width);
  if (turns == 0) return integral_inside(rest, wrap);
  const Eigen::Array4d whole = integral_inside(width, wrap);
  if (wrap == TextureWrap::kMirror && std::fmod(turns, 2) != 0)
    return (turns + 1) * whole - integral_inside(width - rest, wrap);
  return turns * whole + integral_inside(rest, wrap);
}

Eigen::Array4d TextureRow::mean(double begin, double end, TextureWrap wrap) const {
  constexpr double kShortest = 1e-3;  // differences of integrals lose their digits below
  const double length = std::max(std::abs(end - begin), kShortest);
  const double left = (begin + end - length) / 2, right = (begin + end + length) / 2;
  if (left >= 0 && right <= static_cast<double>(pixels_.size()))  // the usual place
    return (integral_from_first(right, wrap) - integral_from_first(left, wrap)) / length;
  return (integral(right, wrap) - integral(left, wrap)) / length;
}

}  // namespace burnish

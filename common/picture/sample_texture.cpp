#include "common/picture/sample_texture.h"

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

double into_picture(double x, TextureWrap wrap) {
  if (!std::isfinite(x)) return 0;
  if (wrap == TextureWrap::kClamp) return std::clamp(x, 0.0, 1.0);
  if (wrap == TextureWrap::kRepeat) return x - std::floor(x);
  const double folded = x - 2 * std::floor(x / 2);  // within 0..2
  return folded > 1 ? 2 - folded : folded;
}

/// Returns the pixel of an index that may be one beyond the border.
uint32_t pixel_of(int64_t index, uint32_t size, TextureWrap wrap) {
  const int64_t last = int64_t{size} - 1;
  if (index < 0) return static_cast<uint32_t>(wrap == TextureWrap::kRepeat ? last : 0);
  if (index > last) return static_cast<uint32_t>(wrap == TextureWrap::kRepeat ? 0 : last);
  return static_cast<uint32_t>(index);
}

PixelPair pixels_at(double x, uint32_t size, TextureWrap wrap) {
  const double place = into_picture(x, wrap) * size - 0.5;  // centres are at halves
  const double below = std::floor(place);
  const auto index = static_cast<int64_t>(below);
  return {pixel_of(index, size, wrap), pixel_of(index + 1, size, wrap), place - below};
}

double mixed(double a, double b, double weight) {
  return a + weight * (b - a);
}

}  // namespace

PixelSquare pixels_around(double u, double v, uint32_t width, uint32_t height,
                          const TextureWraps& wraps) {
  return {pixels_at(u, width, wraps.u), pixels_at(v, height, wraps.v)};
}

Rgba8 mixed_colour(const std::array<Rgba8, 4>& pixels, const PixelSquare& at) {
  const auto& [a, b, c, d] = pixels;
  Rgba8 colour;
  for (size_t i = 0; i < colour.size(); ++i)
    colour[i] = static_cast<uint8_t>(std::lround(
        mixed(mixed(a[i], b[i], at.x.weight), mixed(c[i], d[i], at.x.weight), at.y.weight)));
  return colour;
}

Rgba8 sample_texture(const Picture& picture, double u, double v, const TextureWraps& wraps) {
  const PixelSquare at = pixels_around(u, v, picture.width, picture.height, wraps);
  return mixed_colour({picture.at(at.x.first, at.y.first), picture.at(at.x.second, at.y.first),
                       picture.at(at.x.first, at.y.second), picture.at(at.x.second, at.y.second)},
                      at);
}

}  // namespace burnish

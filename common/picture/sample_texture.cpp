#include "common/picture/sample_texture.h"

#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

/// The two pixels around a coordinate, and the second one's weight.
struct PixelPair {
  uint32_t first;
  uint32_t second;
  double weight;
};

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

Rgba8 sample_texture(const Picture& picture, double u, double v, const TextureWraps& wraps) {
  const PixelPair x = pixels_at(u, picture.width, wraps.u);
  const PixelPair y = pixels_at(v, picture.height, wraps.v);
  const Rgba8& a = picture.at(x.first, y.first);
  const Rgba8& b = picture.at(x.second, y.first);
  const Rgba8& c = picture.at(x.first, y.second);
  const Rgba8& d = picture.at(x.second, y.second);
  Rgba8 colour;
  for (size_t i = 0; i < colour.size(); ++i)
    colour[i] = static_cast<uint8_t>(
        std::lround(mixed(mixed(a[i], b[i], x.weight), mixed(c[i], d[i], x.weight), y.weight)));
  return colour;
}

}  // namespace burnish

#include "client/raster/texel_colour.h"

#include <algorithm>
#include <cmath>

#include "client/raster/shade_math.h"

namespace burnish {
namespace {

ShadeVector texel(const TextureLevel& level, int x, int y) {
  x = std::clamp(x, 0, level.width - 1);
  y = std::clamp(y, 0, level.height - 1);
  const Rgba8& of = level.texels[size_t(y) * level.width + x];
  return {float(of[0]), float(of[1]), float(of[2])};
}

// Between the four texels around a place; 0 to 255.
ShadeVector colour_on_level(const TextureLevel& level, float x, float y) {
  x = lesser(greater(x - 0.5f, -1),
             static_cast<float>(level.width));  // also where it is not finite
  y = lesser(greater(y - 0.5f, -1), static_cast<float>(level.height));
  const float left = std::floor(x), above = std::floor(y);
  const int column = static_cast<int>(left), row = static_cast<int>(above);
  const ShadeVector upper =
      mixed(texel(level, column, row), texel(level, column + 1, row), x - left);
  const ShadeVector lower =
      mixed(texel(level, column, row + 1), texel(level, column + 1, row + 1), x - left);
  return mixed(upper, lower, y - above);
}

// 0: a texel of the finest level is as large as a pixel.
float level_of_detail(TexelPoint here, TexelPoint beside, TexelPoint below) {
  const auto square = [&](TexelPoint to) {
    return (to.x - here.x) * (to.x - here.x) + (to.y - here.y) * (to.y - here.y);
  };
  const float texels = greater(square(beside), square(below));  // a pixel's, squared
  return lesser(0.5f * fast_log2(greater(texels, 1)), kTextureLevels - 1);
}

}  // namespace

ShadeVector texel_colour(const PageTexture& texture, TexelPoint here, TexelPoint beside,
                         TexelPoint below) {
  const float detail = level_of_detail(here, beside, below);
  const int fine = static_cast<int>(detail);
  const float part = detail - static_cast<float>(fine);
  const auto on_level = [&](int level) {
    const auto texels = static_cast<float>(1 << level);
    return colour_on_level(texture.levels[level], here.x / texels, here.y / texels);
  };
  ShadeVector colour = on_level(fine);
  if (part > 0) colour = mixed(colour, on_level(fine + 1), part);
  return (1.0f / 255) * colour;
}

}  // namespace burnish

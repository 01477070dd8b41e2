#include "client/raster/texel_colour.h"

#include <algorithm>
#include <cstring>

#include "client/raster/shade_math.h"

namespace burnish {
namespace {

// Four channels side by side, 16 bits each: a product with a weight up to 256 carries into none.
using Channels = uint64_t;

Channels channels_of(const Rgba8& texel) {
  uint32_t packed;
  std::memcpy(&packed, texel.data(), sizeof packed);
  Channels spread = packed;
  spread = (spread | spread << 16) & 0x0000ffff0000ffff;
  return (spread | spread << 8) & 0x00ff00ff00ff00ff;
}

// Between the four texels around a place; a channel is 256 times a byte.
Channels channels_on_level(const TextureLevel& level, float x, float y) {
  // Half a texel up, so that both are at least 0; also where they are not finite.
  x = lesser(greater(x + 0.5f, 0), static_cast<float>(level.width + 1));
  y = lesser(greater(y + 0.5f, 0), static_cast<float>(level.height + 1));
  const int column = static_cast<int>(x), row = static_cast<int>(y);  // of the right lower texel
  const auto right_part = static_cast<uint32_t>((x - static_cast<float>(column)) * 256 + 0.5f);
  const auto lower_part = static_cast<uint32_t>((y - static_cast<float>(row)) * 256 + 0.5f);
  const uint32_t both = (right_part * lower_part + 128) >> 8;
  const int last_column = level.width - 1, last_row = level.height - 1;
  const int left = std::clamp(column - 1, 0, last_column), right = std::min(column, last_column);
  const Rgba8* upper = level.texels.data() + std::clamp(row - 1, 0, last_row) * level.width;
  const Rgba8* lower = level.texels.data() + std::min(row, last_row) * level.width;
  return channels_of(upper[left]) * (256 - right_part - lower_part + both) +
         channels_of(upper[right]) * (right_part - both) +
         channels_of(lower[left]) * (lower_part - both) + channels_of(lower[right]) * both;
}

ShadeVector colour_of(Channels channels) {
  const auto channel = [&](int number) {
    const auto value = static_cast<int32_t>(channels >> (16 * number) & 0xffff);
    return static_cast<float>(value) / (255 * 256);
  };
  return {channel(0), channel(1), channel(2)};
}

// 0: a texel of the finest level is as large as a pixel.
float level_of_detail(TexelPoint right, TexelPoint down) {
  const float texels = greater(right.x * right.x + right.y * right.y,
                               down.x * down.x + down.y * down.y);  // a pixel's, squared
  return lesser(0.5f * fast_log2(greater(texels, 1)), kTextureLevels - 1);
}

}  // namespace

ShadeVector texel_colour(const PageTexture& texture, TexelPoint place, TexelPoint right,
                         TexelPoint down) {
  const float detail = level_of_detail(right, down);
  const int fine = static_cast<int>(detail);
  const float part = detail - static_cast<float>(fine);
  const auto on_level = [&](int level) {
    const float scale = 1 / static_cast<float>(1 << level);
    return colour_of(channels_on_level(texture.levels[level], place.x * scale, place.y * scale));
  };
  const ShadeVector colour = on_level(fine);
  return part > 0 ? mixed(colour, on_level(fine + 1), part) : colour;
}

}  // namespace burnish

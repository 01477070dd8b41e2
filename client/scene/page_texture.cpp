#include "client/scene/page_texture.h"

#include <algorithm>
#include <utility>

#include "common/base/check.h"

namespace burnish {

static TextureLevel halved(const TextureLevel& fine) {
  TextureLevel half{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
  half.texels.reserve(size_t(half.width) * half.height);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int right = std::min(2 * x + 1, fine.width - 1);
      const int below = std::min(2 * y + 1, fine.height - 1);
      const auto at = [&](int column, int row) {
        return fine.texels[size_t(row) * fine.width + column];
      };
      const Rgba8 four[] = {at(2 * x, 2 * y), at(right, 2 * y), at(2 * x, below), at(right, below)};
      Rgba8 mean;
      for (int c = 0; c < 4; ++c)
        mean[c] = static_cast<uint8_t>((four[0][c] + four[1][c] + four[2][c] + four[3][c] + 2) / 4);
      half.texels.push_back(mean);
    }
  return half;
}

std::array<TextureLevel, kTextureLevels> texture_levels(int width, int height,
                                                        std::vector<Rgba8> texels) {
  BURNISH_CHECK(texels.size() == size_t(width) * height, "one texel per place");
  std::array<TextureLevel, kTextureLevels> levels;
  levels[0] = {width, height, std::move(texels)};
  for (size_t i = 1; i < kTextureLevels; ++i) levels[i] = halved(levels[i - 1]);
  return levels;
}

size_t PageTexture::bytes() const {
  size_t sum = chart_of_triangle.size() * sizeof(uint16_t) + charts.size() * sizeof(TextureChart);
  for (const TextureLevel& level : levels) sum += level.texels.size() * sizeof(Rgba8);
  return sum;
}

}  // namespace burnish

#include "server/prepare/sheets/picture_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/sheets/catmull_rom.h"
#include "server/prepare/sheets/picture_bands.h"

namespace burnish {

namespace {

double wrapped(double i, uint32_t size, TextureWrap wrap) {
  if (wrap == TextureWrap::kClamp) return std::clamp(i, 0.0, size - 1.0);
  const double period = wrap == TextureWrap::kMirror ? 2.0 * size : size;
  const double rest = i - period * std::floor(i / period);
  return rest < size ? rest : period - 1 - rest;
}

/// Returns the texels that four taps take along one axis.
std::array<uint32_t, 4> taps_of(double first, uint32_t size, TextureWrap wrap) {
  std::array<uint32_t, 4> taps;
  for (int k = 0; k < 4; ++k) {
    const double i = first + k;
    const bool is_inside = i >= 0 && i < size;
    taps[k] = static_cast<uint32_t>(is_inside ? i : wrapped(i, size, wrap));
  }
  return taps;
}

}  // namespace

const Rgba8* PictureSampler::tile(const TiledLevel& level, uint32_t column, uint32_t row) {
  const size_t places_apart = level.begin / level.tile_bytes();  // pictures take other slots
  Slot& slot = slots_[(column % kSlotColumns + row * kSlotColumns + places_apart) % kSlots];
  if (slot.level == &level && slot.column == column && slot.row == row) return slot.texels.data();
  slot = {&level, column, row, std::move(slot.texels)};
  slot.texels.resize(level.tile_bytes() / sizeof(Rgba8));
  const Status read = tiles_.read_tile(level, column, row, as_bytes(slot.texels));
  if (!read.is_ok() && status_.is_ok()) status_ = read;
  return slot.texels.data();
}

Rgba8 PictureSampler::texel(const TiledLevel& level, uint32_t x, uint32_t y) {
  const uint32_t rows = level.tile_rows();
  return tile(level, x / kTileSide, y / rows)[size_t{y % rows} * kTileSide + x % kTileSide];
}

Texel PictureSampler::sample(const TiledLevel& level, double x, double y,
                             const TextureWraps& wraps) {
  const double left = std::floor(x - 0.5);
  const double top = std::floor(y - 0.5);
  const auto columns = taps_of(left - 1, level.width, wraps.u);
  const auto rows = taps_of(top - 1, level.height, wraps.v);
  return filtered_by_catmull_rom(x - 0.5 - left, y - 0.5 - top, [&](int row, int column) {
    return texel(level, columns[column], rows[row]);
  });
}

}  // namespace burnish

#include "common/frame_codec/frame_state.h"

#include <array>
#include <limits>

#include "common/frame_codec/frame_sample.h"

namespace burnish {

static bool fits_narrow(std::span<const int32_t> values) {
  uint32_t outside = 0;
  for (const int32_t value : values) outside |= static_cast<uint32_t>(value) + 0x8000u;
  return outside <= std::numeric_limits<uint16_t>::max();
}

void FrameState::read_tile(int tile, std::span<int32_t> values) const {
  const Tile* held = tiles_[tile].get();
  if (held == nullptr)
    std::ranges::fill(values, 0);
  else if (held->wide.empty())
    std::ranges::copy(held->narrow, values.begin());
  else
    std::ranges::copy(held->wide, values.begin());
}

void FrameState::write_tile(int tile, std::span<const int32_t> values) {
  auto fresh = std::make_shared<Tile>();
  if (fits_narrow(values))
    fresh->narrow.assign(values.begin(), values.end());
  else
    fresh->wide.assign(values.begin(), values.end());
  tiles_[tile] = std::move(fresh);
}

uint64_t FrameState::byte_count() const {
  uint64_t bytes = tiles_.size() * sizeof(tiles_[0]);
  for (const auto& tile : tiles_)
    if (tile) bytes += sizeof(Tile) + tile->narrow.size() * 2 + tile->wide.size() * 4;
  return bytes;
}

uint64_t FrameState::byte_count_max(const FrameLayout& layout) {
  return layout.tile_count() * (sizeof(tiles_[0]) + sizeof(Tile)) +
         uint64_t{3} * layout.value_count() * sizeof(int16_t);
}

void write_displacement(const FrameLayout& layout, const FrameState& state, int tile,
                        std::span<Vec3f> displacements) {
  std::array<int32_t, 3 * kTileValues> values;
  const int begin = layout.tile_begin(tile), size = layout.tile_size(tile);
  state.read_tile(tile, std::span(values).first(size_t{3} * size));
  constexpr auto kCellsPerStep = static_cast<float>(1 / kStepsPerCell);
  for (int i = 0; i < size; ++i)
    displacements[layout.source[begin + i]] =
        kCellsPerStep *
        Vec3i(values[i], values[size + i], values[2 * size + i]).template cast<float>();
}

}  // namespace burnish

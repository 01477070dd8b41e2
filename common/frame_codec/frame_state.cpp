#include "common/frame_codec/frame_state.h"

#include <array>

#include "common/evaluation/displacement_steps.h"

namespace burnish {

void FrameState::read_tile(int tile, std::span<int32_t> values) const {
  const NarrowValues* held = tiles_[tile].get();
  if (held == nullptr)
    std::ranges::fill(values, 0);
  else
    held->read(values);
}

void FrameState::write_tile(int tile, std::span<const int32_t> values) {
  tiles_[tile] = std::make_shared<const NarrowValues>(values);
}

uint64_t FrameState::byte_count() const {
  uint64_t bytes = tiles_.size() * sizeof(tiles_[0]);
  for (const auto& tile : tiles_)
    if (tile) bytes += tile->byte_count();
  return bytes;
}

uint64_t FrameState::byte_count_max(const FrameLayout& layout) {
  return layout.tile_count() * (sizeof(tiles_[0]) + sizeof(NarrowValues)) +
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

#include "common/page_frames/page_frame_state.h"

#include <algorithm>

#include "common/evaluation/displacement_steps.h"

namespace burnish {

void PageTile::read(std::span<int32_t> values) const {
  if (narrowed == nullptr)
    std::ranges::fill(values, 0);
  else
    narrowed->read(values);
}

void PageTile::read_displacements(std::span<Vec3f> displacements) const {
  std::vector<int32_t> values(value_count());
  read(values);
  constexpr auto kCellsPerStep = static_cast<float>(1 / kStepsPerCell);
  const size_t size = shown.value_count();
  for (size_t i = 0; i < size; ++i)
    displacements[i] =
        kCellsPerStep *
        Vec3i(values[i], values[size + i], values[2 * size + i]).template cast<float>();
}

const PageTile* PageFrameState::find(PageId page) const {
  const auto number = [](const PageTile& tile) { return tile.shown.page; };
  const auto found = std::ranges::lower_bound(tiles, page, {}, number);
  return found == tiles.end() || number(*found) != page ? nullptr : &*found;
}

uint64_t PageFrameState::byte_count() const {
  uint64_t bytes = tiles.size() * sizeof(tiles[0]);
  for (const PageTile& tile : tiles) {
    if (tile.narrowed) bytes += tile.narrowed->byte_count();
    if (tile.held) bytes += tile.held->capacity();
  }
  return bytes;
}

// Both ends compare so: a page that is shown again may have another copy of its layout.
static bool is_same_page(const ShownPage& a, const ShownPage& b) {
  return a.page == b.page && a.value_count() == b.value_count();
}

PageFrameState start_page_frame(const ShownPages& shown, const PageFrameState& reference) {
  PageFrameState state;
  state.tiles.reserve(shown.pages().size());
  auto old = reference.tiles.begin();
  for (const ShownPage& page : shown.pages()) {
    while (old != reference.tiles.end() && old->shown.page < page.page) ++old;
    if (old != reference.tiles.end() && is_same_page(old->shown, page))
      state.tiles.push_back(*old);
    else
      state.tiles.push_back({.shown = page});
  }
  return state;
}

uint64_t page_state_bytes_max(std::span<const ShownPage> pages) {
  uint64_t bytes = 0;
  for (const ShownPage& page : pages)
    bytes += sizeof(PageTile) + sizeof(NarrowValues) +
             uint64_t{3} * page.value_count() * sizeof(int16_t) + held_bytes(page.layout->vertices);
  return bytes;
}

}  // namespace burnish

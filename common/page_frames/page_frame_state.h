#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/packing/narrow_values.h"
#include "common/page_frames/held_vertices.h"
#include "common/page_frames/shown_pages.h"

namespace burnish {

/// The values of one page after a frame.
struct PageTile {
  ShownPage shown;
  uint8_t gain = 0;                              ///< exponent of two
  std::shared_ptr<const NarrowValues> narrowed;  ///< null: all zero
  HeldVertices held;

  size_t value_count() const { return size_t{3} * shown.value_count(); }
  /// Copies the values out, in 1/256 cell: all x, then all y, then all z.
  /// Needs: values.size() is value_count().
  void read(std::span<int32_t> values) const;
  /// Copies the displacements out. Shapes: one per value. Units: cells.
  void read_displacements(std::span<Vec3f> displacements) const;
};

/// A client's state after a frame. Copies share the values of the pages that no frame between them
/// sent, so remembering a few frames costs little.
struct PageFrameState {
  std::vector<PageTile> tiles;  ///< one per shown page, in the order of their numbers

  /// Returns the tile of a page; null if it is not shown.
  const PageTile* find(PageId page) const;
  uint64_t byte_count() const;  ///< shared values included
};

/// Returns the state that a frame for these pages starts from: the reference's values, zero in
/// pages that it does not show. A key frame has an empty reference.
PageFrameState start_page_frame(const ShownPages& shown, const PageFrameState& reference);

/// Returns the limit of PageFrameState::byte_count() while displacements are below 128 cells.
uint64_t page_state_bytes_max(std::span<const ShownPage> pages);

}  // namespace burnish

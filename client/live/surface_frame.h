#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/base/types.h"
#include "common/pages/page.h"

namespace burnish {

/// The places of a page's vertices in a frame.
struct PageMove {
  std::vector<Vec3f> displacements;  ///< cells, one per vertex in the page's order
  uint8_t gain = 0;                  ///< exponent of two: no cell of the page has a larger beta
};

/// The surface in one frame, for all pages that it carries. Immutable once it is shared.
struct SurfaceFrame {
  uint64_t number = 0;        ///< rises from 1 over all streams of a link
  bool is_exact = false;      ///< nothing is rounded beyond 1/256 cell
  float largest_move = 0;     ///< cells, of the whole surface
  std::vector<PageId> pages;  ///< rising
  /// One per page. The pointer of the frame before where nothing has changed.
  std::vector<std::shared_ptr<const PageMove>> moves;

  /// Returns nullptr for a page that the frame does not carry.
  const PageMove* find(PageId page) const { return share(page).get(); }
  std::shared_ptr<const PageMove> share(PageId page) const;
};

}  // namespace burnish

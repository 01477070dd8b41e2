#include "client/live/surface_frame.h"

#include <algorithm>

namespace burnish {

std::shared_ptr<const PageMove> SurfaceFrame::share(PageId page) const {
  const auto found = std::ranges::lower_bound(pages, page);
  if (found == pages.end() || *found != page) return nullptr;
  return moves[static_cast<size_t>(found - pages.begin())];
}

}  // namespace burnish

#include "client/cli/bench/load_surface.h"

#include <algorithm>
#include <optional>

#include "common/base/limits.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"

namespace burnish {

static Result<std::shared_ptr<const Page>> decode_part(const PagePart& part, const PageHead& head) {
  ASSIGN_OR_RETURN(Page page, decode_page(part.bytes));
  RETURN_IF_ERROR(check_page_in_scan(page, part.number, head));
  return std::make_shared<const Page>(std::move(page));
}

static Status fetch_some(Connection& connection, const PagesWish& wish, LoadSurface& surface) {
  Status here;
  const auto take_page = [&](const PagePart& part) {
    auto page = decode_part(part, surface.head);
    here = page.status();
    if (here.is_ok()) surface.pages.push_back(std::move(*page));
    return here.is_ok();
  };
  const Status there = connection.fetch_pages(
      wish, {.block = [](const PagePart&) { return true; }, .page = take_page});
  return here.is_ok() ? there : here;
}

// Pages are numbered from fine to coarse, and all that replaces a page is coarser: the last ones
// are a legal cut.
static Status fetch_last(Connection& connection, const std::string& scan, size_t pages_max,
                         LoadSurface& surface) {
  const uint32_t all = surface.head.page_count();
  const size_t count = std::min<size_t>(pages_max == 0 ? all : pages_max, kShownPagesMax);
  PagesWish wish{.scan = scan, .blocks = {}, .pages = {}};
  for (PageId page = all - static_cast<PageId>(std::min<size_t>(count, all)); page < all; ++page) {
    wish.pages.push_back(page);
    if (wish.pages.size() < kPagePartsPerFetchMax && page + 1 < all) continue;
    RETURN_IF_ERROR(fetch_some(connection, wish, surface));
    wish.pages.clear();
  }
  return Status::ok();
}

Result<std::shared_ptr<const LoadSurface>> fetch_load_surface(Connection& connection,
                                                              const std::string& session,
                                                              size_t pages_max) {
  ASSIGN_OR_RETURN(const SessionState state, connection.state(session));
  const std::string& scan = state.session.scan_id;
  ASSIGN_OR_RETURN(const PagesDescription description, connection.describe_pages(scan, {}));
  auto surface = std::make_shared<LoadSurface>();
  surface->depth = state.session.key.depth;
  ASSIGN_OR_RETURN(surface->head, decode_head(description.head));
  surface->pages_fingerprint = pages_fingerprint(description.head);
  RETURN_IF_ERROR(fetch_last(connection, scan, pages_max, *surface));
  for (const auto& page : surface->pages)
    for (const Vec3i& position : page->positions)
      surface->points.push_back(surface->head.grid.to_file(position));
  return std::shared_ptr<const LoadSurface>(std::move(surface));
}

}  // namespace burnish

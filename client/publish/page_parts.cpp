#include "client/publish/page_parts.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "client/publish/published_tile.h"
#include "common/page_frames/shown_pages.h"
#include "common/pages/directory_codec.h"
#include "common/pages/page_codec.h"

namespace burnish {

namespace {

constexpr const char* kPagesPhase = "publishing pages";

/// Returns the numbers from `begin` on, at most as many as one request may have.
std::vector<uint32_t> batch_from(uint32_t begin, uint32_t end) {
  std::vector<uint32_t> batch(std::min<size_t>(kPagePartsPerFetchMax, end - begin));
  std::iota(batch.begin(), batch.end(), begin);
  return batch;
}

Result<std::vector<PagePart>> fetch(Connection& connection, const PagesWish& wish) {
  std::vector<PagePart> parts;
  const auto take = [&](PagePart part) {
    parts.push_back(std::move(part));
    return true;
  };
  RETURN_IF_ERROR(connection.fetch_pages(wish, {take, take}));
  const std::vector<uint32_t>& wanted = wish.blocks.empty() ? wish.pages : wish.blocks;
  const auto is_wanted = [](const PagePart& part, uint32_t number) {
    return part.number == number;
  };
  if (!std::ranges::equal(parts, wanted, is_wanted))
    return data_loss("server " + connection.server() + " sent other pages than were asked for");
  return parts;
}

Result<std::shared_ptr<const Page>> decoded(const PagePart& part, const PageHead& head) {
  ASSIGN_OR_RETURN(Page page, decode_page(part.bytes));
  RETURN_IF_ERROR(check_page_in_scan(page, part.number, head));
  return std::make_shared<const Page>(std::move(page));
}

/// A page and what stands for its colours and gains, in the order of their tiles.
constexpr std::array<PageId, 3> kTiles = {0, kColourPages, kGainPages};

std::shared_ptr<const Page> numbered(const Page& page, PageId number) {
  Page other = page;
  other.id = number;
  return std::make_shared<const Page>(std::move(other));
}

/// Returns the tile of a page, of its colours or gains; empty if the frame has none.
std::string tile_in(const SurfaceFrame& frame, const Page& page, PageId number) {
  const PageMove* const move = frame.find(number);
  return move ? pack_tile(published_tile(page, *move)) : std::string();
}

/// Writes a batch of pages with their tiles.
Status write_pages(const std::vector<PagePart>& fetched, const PageHead& head,
                   RestingSurface& surface, PartsWriter& parts, const Progress& progress) {
  std::vector<std::shared_ptr<const Page>> pages, shown;
  for (const PagePart& part : fetched) {
    ASSIGN_OR_RETURN(const auto page, decoded(part, head));
    pages.push_back(page);
    for (const PageId tile : kTiles)
      if (tile == 0 || head.has_colours) shown.push_back(numbered(*page, page->id | tile));
  }
  ASSIGN_OR_RETURN(const auto frame, surface.frame_of(shown, progress));
  for (size_t i = 0; i < fetched.size(); ++i) {
    RETURN_IF_ERROR(parts.add(page_event(fetched[i])));
    for (const PageId tile : kTiles)
      RETURN_IF_ERROR(parts.add(tile_in(*frame, *pages[i], fetched[i].number | tile)));
  }
  return Status::ok();
}

}  // namespace

Status write_page_parts(Connection& connection, const Opening& opening, RestingSurface& surface,
                        PartsWriter& parts, const Progress& progress) {
  ASSIGN_OR_RETURN(const PageHead head, decode_head(opening.pages.head));
  const std::string& scan = opening.scan.scan.id;
  for (uint32_t begin = 0; begin < head.block_count(); begin += kPagePartsPerFetchMax) {
    ASSIGN_OR_RETURN(const auto blocks,
                     fetch(connection, {scan, batch_from(begin, head.block_count()), {}}));
    for (const PagePart& block : blocks) RETURN_IF_ERROR(parts.add(block_event(block)));
  }
  for (uint32_t begin = 0; begin < head.page_count(); begin += kPagePartsPerFetchMax) {
    const Progress at = [&, done = static_cast<double>(begin) / head.page_count()](std::string_view,
                                                                                   double) {
      return report(progress, kPagesPhase, done);
    };
    if (!report(at, kPagesPhase, 0)) return cancelled("cancelled");
    ASSIGN_OR_RETURN(const auto pages,
                     fetch(connection, {scan, {}, batch_from(begin, head.page_count())}));
    RETURN_IF_ERROR(write_pages(pages, head, surface, parts, at));
  }
  return Status::ok();
}

}  // namespace burnish

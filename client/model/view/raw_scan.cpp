#include "client/model/view/raw_scan.h"

#include <utility>

#include "client/connection/connection.h"
#include "client/model/settings/recent_sessions.h"
#include "client/scene/likely_up.h"
#include "client/scene/raw_pages.h"
#include "client/surface/page_desk.h"
#include "common/pages/directory_codec.h"

namespace burnish {

/// Returns the pages of the finest level that one request brings: half a megabyte.
static PageRange coarse_level(const PageHead& head, uint64_t triangles_max) {
  const uint64_t pages_max =
      std::min<uint64_t>(kPagePartsPerFetchMax, triangles_max / kPageTrianglesMax);
  int level = head.level_count() - 1;
  while (level > 0 && head.level_pages[size_t(level) - 1] <= pages_max) --level;
  return {head.level_begin(level), head.level_begin(level + 1)};
}

static RawScan raw_scan_of(const ScanInfo& scan, const PageHead& head) {
  RawScan raw{.name = scan.name,
              .size_bytes = bytes_on_disk(scan),
              .vertices = scan.statistics.vertices,
              .triangles = scan.statistics.triangles,
              .has_colours = head.has_colours,
              .statistics = scan.statistics};
  raw.box = {scan.statistics.box_min, scan.statistics.box_max};
  raw.up = likely_up(raw.box, scan.unit, scan.format);
  raw.space = make_page_space(head.grid, scan.default_depth);
  return raw;
}

Result<RawScan> fetch_raw_scan(Connection& connection, const std::string& scan,
                               uint64_t triangles_max, const std::function<bool()>& is_wanted) {
  const auto goes_on = [&](std::string_view, double) { return is_wanted(); };
  ASSIGN_OR_RETURN(const ScanDescription whole, connection.describe_scan(scan, 0));
  ASSIGN_OR_RETURN(const PagesDescription described, connection.describe_pages(scan, goes_on));
  ASSIGN_OR_RETURN(const PageHead head, decode_head(described.head));
  if (!is_wanted()) return cancelled("nobody waits for the pages any more");
  const PageRange level = coarse_level(head, triangles_max);
  PagesWish wish{.scan = scan};
  for (PageId page = level.begin; page < level.end; ++page) wish.pages.push_back(page);
  RawScan raw = raw_scan_of(whole.scan, head);
  Status damage = Status::ok();
  const auto take_page = [&](PagePart part) {
    DecodedPage page = decode_in_scan({part.number, std::move(part.bytes)}, head);
    damage = page.page.status();
    raw.pages.push_back(std::move(page.mesh));
    return damage.is_ok() && is_wanted();
  };
  const Status fetched =
      connection.fetch_pages(wish, {.block = [](PagePart) { return true; }, .page = take_page});
  RETURN_IF_ERROR(damage);
  RETURN_IF_ERROR(fetched);
  if (raw.pages.size() == wish.pages.size()) return raw;
  return data_loss("server " + connection.server() + " sent " + std::to_string(raw.pages.size()) +
                   " of " + std::to_string(wish.pages.size()) + " pages");
}

Status put_into(PageRenderer& renderer, RawScan& scan) {
  const RawPages raw{scan.space, scan.box, std::exchange(scan.pages, {})};
  ASSIGN_OR_RETURN(scan.patches, upload_pages(raw, renderer));
  return Status::ok();
}

DrawStyle style_of(const RawScan& scan) {
  DrawStyle style;
  if (scan.has_colours) style.colouring = Colouring::kScan;
  return style;
}

uint64_t drawn_triangles(const RawScan& scan) {
  uint64_t triangles = 0;
  for (const PatchRange& patch : scan.patches) triangles += patch.count;
  return triangles;
}

}  // namespace burnish

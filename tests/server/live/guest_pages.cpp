#include "tests/server/live/guest_pages.h"

#include "common/base/check.h"
#include "common/page_frames/page_corners.h"

namespace burnish {

GuestPages::GuestPages(std::shared_ptr<const ScanPages> scan, int depth)
    : scan_(std::move(scan)), depth_(depth) {}

Page GuestPages::page(PageId number) const {
  return scan_->file.read_page(number).value();
}

ShownPage GuestPages::shown(PageId number) const {
  const Page read = page(number);
  const PageLayout layout =
      kind_ == PageFrameKind::kVertices
          ? make_vertex_page_layout(read)
          : make_corner_page_layout(make_page_corners(read.positions, head().grid.bits, depth_));
  return {number, std::make_shared<const PageLayout>(layout)};
}

PageChange GuestPages::change_of(const ShowPages& change) const {
  PageChange made{change.revision, {}, change.removed};
  for (const PageId number : change.added) made.added.push_back(shown(number));
  return made;
}

void GuestPages::show(const ShowPages& change) {
  const Status status = decoder_.show(change_of(change), head().page_count());
  BURNISH_CHECK(status.is_ok(), status.message());
  changes_.push_back(change);
}

// A decoder of another kind begins with the pages of the newest frame.
void GuestPages::begin(PageFrameKind kind) {
  kind_ = kind;
  ShownPages begun;
  for (uint32_t i = 0; i < revision_; ++i) begun = begun.changed(change_of(changes_[i]));
  decoder_ = PageFrameDecoder(kind, begun);
  for (size_t i = revision_; i < changes_.size(); ++i)
    BURNISH_CHECK(decoder_.show(change_of(changes_[i]), head().page_count()).is_ok(), "again");
}

void GuestPages::forget() {
  begin(kind_);
}

DecodedPageFrame GuestPages::decode(std::span<const uint8_t> frame) {
  const PageFrameHeader header = read_page_frame_header(frame).value();
  if (header.kind != kind_) begin(header.kind);
  const auto seen = decoder_.decode(frame);
  BURNISH_CHECK(seen.is_ok(), seen.status().message());
  revision_ = seen->revision;
  return seen.value();
}

std::vector<int32_t> GuestPages::values() const {
  std::vector<int32_t> all;
  for (const PageTile& tile : state().tiles) {
    std::vector<int32_t> values(tile.value_count());
    tile.read(values);
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

}  // namespace burnish

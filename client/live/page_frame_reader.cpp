#include "client/live/page_frame_reader.h"

#include <utility>

#include "common/base/check.h"

namespace burnish {

static PageFrameKind other_kind(PageFrameKind kind) {
  return kind == PageFrameKind::kVertices ? PageFrameKind::kCorners : PageFrameKind::kVertices;
}

PageFrameReader PageFrameReader::in_other_kind() const {
  PageFrameReader other({other_kind(terms_.kind), terms_.bits, terms_.depth}, page_count_);
  std::vector<ShownPage> relaid;
  for (const auto& [page, framed] : framed_) {
    const FramedPage& again =
        other.framed_.emplace(page, frame_page(framed.page, other.terms_)).first->second;
    relaid.push_back(again.shown);
  }
  other.shown_ = shown_.with_layouts(std::move(relaid));
  other.decoder_ = PageFrameDecoder(other.terms_.kind, other.shown_);
  for (const Change& waiting : changes_) {
    Change change{.change = {waiting.change.revision, {}, waiting.change.removed}, .added = {}};
    for (const FramedPage& framed : waiting.added)
      change.added.push_back(frame_page(framed.page, other.terms_));
    const Status expected = other.expect(std::move(change));
    BURNISH_CHECK(expected.is_ok(), expected.message());
  }
  return other;
}

Status PageFrameReader::show(const ShowPages& change,
                             const std::vector<std::shared_ptr<const Page>>& added) {
  Change next{.change = {change.revision, {}, change.removed}, .added = {}};
  for (const auto& page : added) next.added.push_back(frame_page(page, terms_));
  return expect(std::move(next));
}

Status PageFrameReader::expect(Change change) {
  for (const FramedPage& framed : change.added) change.change.added.push_back(framed.shown);
  RETURN_IF_ERROR(decoder_.show(change.change, page_count_));
  changes_.push_back(std::move(change));
  return Status::ok();
}

Result<DecodedPageFrame> PageFrameReader::decode(std::span<const uint8_t> bytes) {
  ASSIGN_OR_RETURN(DecodedPageFrame frame, decoder_.decode(bytes));
  while (!changes_.empty() && changes_.front().change.revision <= frame.revision) {
    adopt(std::move(changes_.front()));
    changes_.pop_front();
  }
  return frame;
}

void PageFrameReader::adopt(Change change) {
  shown_ = shown_.changed(change.change);
  for (const PageId page : change.change.removed) framed_.erase(page);
  for (FramedPage& framed : change.added)
    framed_.insert_or_assign(framed.shown.page, std::move(framed));
}

std::shared_ptr<const PageMove> PageFrameReader::move_of(const PageTile& tile) const {
  return burnish::move_of(framed_.at(tile.shown.page), tile, terms_);
}

}  // namespace burnish

#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "client/live/framed_page.h"
#include "common/page_frames/page_frame_decoder.h"
#include "common/service/live.h"

namespace burnish {

/// Reads the frames of one stream while they are of one kind. It keeps the pages that frames carry
/// or are about to carry, so that a reader of the other kind can take over.
class PageFrameReader {
 public:
  /// Begins with no page.
  PageFrameReader(const FrameTerms& terms, uint32_t page_count)
      : terms_(terms), page_count_(page_count), decoder_(terms.kind) {}

  PageFrameKind kind() const { return terms_.kind; }
  /// Returns a reader of the other kind for the frames that follow. It holds no reference yet.
  PageFrameReader in_other_kind() const;

  /// Notes what the server is about to hear. Needs: `added` has the pages of the change.
  /// Fails: as PageFrameDecoder::show().
  Status show(const ShowPages& change, const std::vector<std::shared_ptr<const Page>>& added);

  /// Fails: as PageFrameDecoder::decode(); then nothing has changed.
  Result<DecodedPageFrame> decode(std::span<const uint8_t> bytes);

  /// Returns the values of the newest frame.
  const PageFrameState& state() const { return decoder_.state(); }
  /// Returns the revision of the newest frame; 0 before the first.
  uint32_t shown_revision() const { return shown_.revision(); }
  /// Evaluates a tile of the newest frame.
  std::shared_ptr<const PageMove> move_of(const PageTile& tile) const;

 private:
  /// Said, and not in a frame yet.
  struct Change {
    PageChange change;
    std::vector<FramedPage> added;
  };

  Status expect(Change change);
  void adopt(Change change);

  FrameTerms terms_;
  uint32_t page_count_;
  PageFrameDecoder decoder_;
  ShownPages shown_;                     // by the newest frame
  std::map<PageId, FramedPage> framed_;  // the pages of shown_
  std::deque<Change> changes_;           // that follow shown_
};

}  // namespace burnish

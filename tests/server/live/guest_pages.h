#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/page_frames/page_frame_decoder.h"
#include "common/service/live.h"
#include "server/library/open_pages.h"

namespace burnish {

/// The pages of a client in a test, and the frames that move them. It begins with no page, and
/// takes frames of either kind.
class GuestPages {
 public:
  /// `depth`: of the session.
  GuestPages(std::shared_ptr<const ScanPages> scan, int depth);

  const PageHead& head() const { return scan_->file.directory().head; }
  Page page(PageId number) const;

  /// Notes a change, as a client does before it tells the server.
  void show(const ShowPages& change);

  /// Decodes a frame. Needs: a frame of this stream whose reference is held.
  DecodedPageFrame decode(std::span<const uint8_t> frame);

  /// Forgets all frames.
  void forget();

  PageFrameKind kind() const { return kind_; }
  uint32_t revision() const { return revision_; }               ///< of the newest frame
  uint32_t newest_revision() const { return changes_.size(); }  ///< that the client asked for
  const PageFrameState& state() const { return decoder_.state(); }
  std::vector<int32_t> values() const;  ///< of all pages, in 1/256 cell

 private:
  ShownPage shown(PageId number) const;
  PageChange change_of(const ShowPages& change) const;
  void begin(PageFrameKind kind);

  const std::shared_ptr<const ScanPages> scan_;
  const int depth_;
  std::vector<ShowPages> changes_;  // of all revisions
  PageFrameKind kind_ = PageFrameKind::kVertices;
  PageFrameDecoder decoder_{kind_};
  uint32_t revision_ = 0;
};

}  // namespace burnish

#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/page_frames/page_frame_header.h"
#include "common/page_frames/page_frame_state.h"

namespace burnish {

/// Limit of changes that a client has asked for and no frame shows yet.
inline constexpr size_t kPageChangesInFlightMax = 64;

struct DecodedPageFrame {
  uint64_t sequence = 0;  ///< to acknowledge
  uint32_t revision = 0;  ///< of the pages that the state now has
  bool is_key = false;
  int step_shift = 0;      ///< 0: the values are exactly the sampled displacement
  float largest_move = 0;  ///< of the whole surface, cells
  /// Pages whose values or held vertices differ from those of the frame decoded before, or that it
  /// did not have.
  std::vector<PageId> changed_pages;
};

/// Turns the frames of one stream back into states. Safe for any bytes. Not thread-safe.
class PageFrameDecoder {
 public:
  /// A decoder that replaces another in the middle of a stream begins with what that one shows.
  explicit PageFrameDecoder(PageFrameKind kind, ShownPages shown = {});

  /// Notes a change of the shown pages. Call it before the server hears of the change.
  /// Needs: the layouts of the added pages, so the client holds them already.
  /// Fails: as ShownPages::check(); resource_exhausted (kPageChangesInFlightMax).
  Status show(const PageChange& change, uint32_t page_count);

  /// A failed call changes nothing. Fails:
  /// - data_loss: the bytes are damaged, or not a frame;
  /// - unimplemented: another version of the format;
  /// - invalid_argument: a frame of another kind, or of a revision that nobody asked for;
  /// - failed_precondition: the decoder does not hold its reference; tell
  ///   PageFrameEncoder::refuse();
  /// - already_exists: a late frame, not newer than the shown one; nothing to do.
  Result<DecodedPageFrame> decode(std::span<const uint8_t> bytes);

  /// Returns the state to show; empty before the first frame.
  const PageFrameState& state() const { return state_; }
  /// Returns the pages of the newest change, which later frames will have.
  const ShownPages& newest_shown() const { return revisions_.back(); }

 private:
  struct HeldFrame {
    uint64_t sequence;
    uint64_t checksum;
    PageFrameState state;
  };

  Status check_belongs(const PageFrameHeader& header) const;
  Result<PageFrameState> start_of(const PageFrameHeader& header) const;
  const ShownPages& pages_of(uint32_t revision) const;
  void remember(const PageFrameHeader& header, PageFrameState state);

  PageFrameKind kind_;
  std::deque<ShownPages> revisions_;  // rising by one, from the shown one on; never empty
  PageFrameState state_;
  std::deque<HeldFrame> held_;  // rising
  uint64_t reference_ = 0;      // reference of the shown frame: the encoder may name it again
};

}  // namespace burnish

#pragma once

#include <cstdint>
#include <deque>

#include "common/page_frames/page_frame_state.h"

namespace burnish {

/// Limit of frames that are sent but not acknowledged. Older frames are forgotten, so a silent
/// client costs bounded memory. A decoder remembers as many frames.
inline constexpr size_t kPageFramesInFlightMax = 8;

struct SentPageFrame {
  uint64_t sequence = 0;
  uint64_t reference = 0;
  uint64_t checksum = 0;
  PageFrameState state;
  bool acknowledged = false;
};

/// The frames that an encoder remembers: those in flight, the newest acknowledged one, and its
/// spare, the one acknowledged before.
class SentPageFrames {
 public:
  void add(SentPageFrame frame);
  /// Ignores unknown and forgotten frames.
  void acknowledge(uint64_t sequence);
  /// Forgets the reference of this frame, and the frames in flight that have the same one.
  void refuse(uint64_t sequence);
  void clear() { frames_.clear(); }

  /// Returns the frame that the next one refers to; null if there is none.
  const SentPageFrame* newest_acknowledged() const;
  /// Returns a frame; null if it is forgotten.
  const SentPageFrame* find(uint64_t sequence) const;
  /// Returns the bytes of all frames. A page's values that several frames share count once for
  /// each.
  uint64_t byte_count() const;

  static constexpr size_t kFramesMax = kPageFramesInFlightMax + 2;

 private:
  std::deque<SentPageFrame> frames_;  // rising
};

}  // namespace burnish

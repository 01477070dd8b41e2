#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "common/frame_codec/frame_header.h"
#include "common/frame_codec/frame_layout.h"
#include "common/frame_codec/frame_sample.h"
#include "common/frame_codec/frame_state.h"

namespace burnish {

/// Frames that are sent and not yet acknowledged; older ones are forgotten, so that a silent client
/// costs bounded memory. Also how many frames a decoder remembers.
inline constexpr size_t kFramesInFlightMax = 8;

struct EncodedFrame {
  uint64_t sequence = 0;
  uint64_t reference = 0;   ///< 0: a key frame
  uint32_t sent_tiles = 0;  ///< 0: the reference shows all there is to show
  bool is_complete = true;  ///< no tile was left for the next frame
  std::vector<uint8_t> bytes;
};

/// Makes the frames of one client: each is the difference to the newest frame that this client has
/// acknowledged, or a key frame when there is none. Not thread-safe.
class FrameEncoder {
 public:
  explicit FrameEncoder(std::shared_ptr<const FrameLayout> layout);

  /// After a still frame the client holds exactly the sample. After a moving one a vertex is off by
  /// at most half of 1/64 cell where vertices are sent, and by 1/64 cell where coefficients are.
  /// A moving frame that would have more than `bytes_max` before compression is rounded more
  /// coarsely, down to kCoarsest; a still one leaves its last tiles to the next.
  /// Needs: a sample of this layout.
  EncodedFrame encode(const FrameSample& sample, FrameStep step, size_t bytes_max = SIZE_MAX);

  /// The client holds this frame. Frames that are unknown or forgotten are ignored.
  void acknowledge(uint64_t sequence);

  /// The client could not decode this frame for want of its reference: from now on an older
  /// acknowledged frame serves, else a key frame.
  void refuse(uint64_t sequence);

  /// The client holds nothing: the next frame is a key frame.
  void request_key_frame();

  /// What the client holds once it has decoded this frame; null when that is forgotten.
  const FrameState* sent_state(uint64_t sequence) const;

  /// What is remembered of sent frames. Tiles that they share count once for each.
  uint64_t byte_count() const;

  /// What byte_count() stays within while displacements are below 128 cells, whatever the client
  /// acknowledges.
  static uint64_t byte_count_max(const FrameLayout& layout);

 private:
  struct SentFrame {
    uint64_t sequence;
    uint64_t reference;
    uint64_t checksum;
    FrameState state;
    bool acknowledged = false;
  };

  struct Draft;
  Draft draft(const FrameSample& sample, int step_shift, size_t bytes_max) const;
  const SentFrame* newest_acknowledged() const;
  void remember(SentFrame frame);

  std::shared_ptr<const FrameLayout> layout_;
  static constexpr size_t kAcknowledgedMax = 2;  // a reference and its spare
  std::deque<SentFrame> sent_;                   // rising
  uint64_t next_sequence_ = 1;
};

}  // namespace burnish

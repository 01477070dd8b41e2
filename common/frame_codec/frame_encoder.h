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

/// Limit of frames that are sent but not acknowledged. Older frames are forgotten, so a silent
/// client costs bounded memory. A decoder remembers as many frames.
inline constexpr size_t kFramesInFlightMax = 8;

struct EncodedFrame {
  uint64_t sequence = 0;
  uint64_t reference = 0;   ///< 0: a key frame
  uint32_t sent_tiles = 0;  ///< 0: the reference already shows everything
  bool is_complete = true;  ///< no tile was left for the next frame
  std::vector<uint8_t> bytes;
};

/// Makes the frames of one client: each is the difference to the newest frame that this client has
/// acknowledged, or a key frame when there is none. Not thread-safe.
class FrameEncoder {
 public:
  explicit FrameEncoder(std::shared_ptr<const FrameLayout> layout);

  /// Encodes the next frame. After a still frame the client holds exactly the sample. After a
  /// moving frame a vertex is off by at most 1/128 cell if the frame has vertices, and by at most
  /// 1/64 cell if it has coefficients. A moving frame above `bytes_max` before compression is
  /// rounded more coarsely, up to kCoarsest; a still frame leaves its last tiles to the next frame.
  /// Needs: a sample of this layout.
  EncodedFrame encode(const FrameSample& sample, FrameStep step, size_t bytes_max = SIZE_MAX);

  /// Notes that the client holds this frame. Ignores unknown and forgotten frames.
  void acknowledge(uint64_t sequence);

  /// Notes that the client could not decode this frame because it lacks the reference. The next
  /// frame refers to an older acknowledged frame, or is a key frame.
  void refuse(uint64_t sequence);

  /// Notes that the client holds nothing: the next frame is a key frame.
  void request_key_frame();

  /// Returns the client's state after this frame; null if it is forgotten.
  const FrameState* sent_state(uint64_t sequence) const;

  /// Returns the bytes of remembered frames. A tile that several frames share counts once for each.
  uint64_t byte_count() const;

  /// Returns the limit of byte_count() while displacements are below 128 cells, whatever the client
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

#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/frame_codec/frame_header.h"
#include "common/frame_codec/frame_layout.h"
#include "common/frame_codec/frame_state.h"

namespace burnish {

struct DecodedFrame {
  uint64_t sequence = 0;  ///< to acknowledge
  bool is_key = false;
  bool is_still = false;           ///< what it brings is exactly the rounded displacement
  std::vector<int> changed_tiles;  ///< since the frame that was decoded before
};

/// Turns the frames of one stream back into states. Any bytes are safe. Not thread-safe.
class FrameDecoder {
 public:
  explicit FrameDecoder(std::shared_ptr<const FrameLayout> layout);

  /// A failed call changes nothing. Fails:
  /// - data_loss: the bytes are damaged, or no frame;
  /// - unimplemented: another version of the format;
  /// - invalid_argument: a frame of another layout;
  /// - failed_precondition: its reference is not held: tell the encoder (FrameEncoder::refuse);
  /// - already_exists: not newer than what is shown, as late frames are: nothing to do.
  Result<DecodedFrame> decode(std::span<const uint8_t> bytes);

  /// What to show: all zero before the first frame.
  const FrameState& state() const { return shown_; }

 private:
  struct HeldFrame {
    uint64_t sequence;
    uint64_t checksum;
    FrameState state;
  };

  Status check_belongs(const FrameHeader& header) const;
  Result<FrameState> reference_of(const FrameHeader& header) const;
  void remember(const FrameHeader& header, FrameState state);

  std::shared_ptr<const FrameLayout> layout_;
  FrameState shown_;
  std::deque<HeldFrame> held_;  // rising
  uint64_t reference_ = 0;      // of the frame shown: the encoder may name it again
};

}  // namespace burnish

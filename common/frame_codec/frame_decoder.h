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
  bool is_still = false;           ///< its tiles hold exactly the rounded displacement
  std::vector<int> changed_tiles;  ///< since the frame decoded before it
};

/// Turns the frames of one stream back into states. Safe for any bytes. Not thread-safe.
class FrameDecoder {
 public:
  explicit FrameDecoder(std::shared_ptr<const FrameLayout> layout);

  /// A failed call changes nothing. Fails:
  /// - data_loss: the bytes are damaged, or not a frame;
  /// - unimplemented: another version of the format;
  /// - invalid_argument: a frame of another layout;
  /// - failed_precondition: the decoder does not hold its reference; tell FrameEncoder::refuse();
  /// - already_exists: a late frame, not newer than the shown one; nothing to do.
  Result<DecodedFrame> decode(std::span<const uint8_t> bytes);

  /// Returns the state to show; all zero before the first frame.
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
  uint64_t reference_ = 0;      // reference of the shown frame: the encoder may name it again
};

}  // namespace burnish

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "client/connection/live_news.h"
#include "common/frame_codec/frame_decoder.h"
#include "common/view/view.h"

namespace burnish {

/// Turns the frames of one live session, over any number of streams, into displacements, and keeps
/// what is to be answered about them. Not thread-safe.
class FrameReceiver {
 public:
  explicit FrameReceiver(std::shared_ptr<const View> view) : view_(std::move(view)) {}

  /// A stream begins. Fails: failed_precondition when its frames are not of this view.
  Status welcome(const Welcome& welcome);

  /// Where the surface is now, with the tiles that this frame changed; nothing where it has not
  /// moved, or the frame could not be decoded: then the server is asked for a better one.
  /// Fails: unimplemented, invalid_argument (no frame of this session will ever do), data_loss (a
  /// frame before the welcome).
  Result<std::optional<Displacement>> receive(const std::string& data);

  /// What the server has to know about the frames since the last call.
  FrameCredit take_answers();
  bool has_answers() const;

 private:
  std::shared_ptr<const FrameLayout> layout_of(FrameContent content);
  std::optional<Displacement> moved(const DecodedFrame& frame);

  const std::shared_ptr<const View> view_;
  std::array<std::shared_ptr<const FrameLayout>, 2> layouts_;  // by content, once they are made
  std::shared_ptr<const FrameLayout> layout_;
  std::optional<FrameDecoder> decoder_;
  bool all_changed_ = false;  // what was shown is of an earlier stream
  FrameCredit answers_;
};

}  // namespace burnish

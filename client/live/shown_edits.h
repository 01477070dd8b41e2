#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "client/live/live_news.h"

namespace burnish {

/// When the first frame came that has an edit, or a preview. A frame may come before the edit's
/// acknowledgement does.
class ShownEdits {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// The edits are in the session's first `edits` edits.
  void acknowledged(std::vector<std::string> ids, Time since, uint64_t edits);

  /// The count-th preview of this stream has been sent.
  void preview_sent(uint64_t count, Time since);

  /// A frame has come that has seen so many edits of the session and previews of this stream.
  void frame(uint64_t edits, uint64_t previews, Time now);

  /// A new stream: previews are counted anew.
  void restart();

  /// Returns whether a frame has seen every preview of this stream that has been sent, and is not
  /// of an earlier stream that had previews.
  bool shows_previews() const { return previews_.empty() && !is_frame_old_; }

  /// Edits whose first frame has come since the last call.
  std::vector<EditsShown> take_edits();
  /// Milliseconds that previews took, since the last call.
  std::vector<double> take_previews();

 private:
  struct Waiting {
    std::vector<std::string> ids;
    Time since;
    uint64_t edits;
  };
  struct Sent {
    uint64_t count;
    Time since;
  };
  struct Level {
    uint64_t edits;
    Time when;  // of the first frame that had them
  };

  std::vector<Waiting> waiting_;
  std::deque<Sent> previews_;
  bool has_previewed_ = false;  // on any stream
  bool is_frame_old_ = false;   // the newest frame is of an earlier stream, and may show previews
  std::deque<Level> levels_;    // rising
  std::vector<EditsShown> shown_;
  std::vector<double> preview_ms_;
};

}  // namespace burnish

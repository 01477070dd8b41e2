#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "client/live/pages_to_show.h"
#include "common/edit/edit.h"
#include "common/service/live.h"

namespace burnish {

/// Says to a live session what a client has to say, one message at a time. Waiting messages are
/// merged, so that a stalled link costs bounded memory; edits are kept until they are answered, and
/// said again on the next stream.
class LiveOutbox {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Edits that were sent together.
  struct Batch {
    std::vector<Edit> edits;
    Time since;  ///< when they were handed over
    bool sent = false;
  };

  LiveOutbox(Greeting greeting, uint32_t page_count)
      : greeting_(std::move(greeting)), pages_(page_count) {}

  void apply(std::vector<Edit> edits, Time now);
  void preview(const std::string& edit_id, PreviewChange change, Time now);
  /// Says nothing of a preview of which nothing was said.
  void drop_preview(const std::string& edit_id);
  void move_brush(const std::optional<BrushRing>& ring);

  /// The pages of frames. Their changes are said right after the greeting.
  PagesToShow& pages() { return pages_; }

  /// A new stream: the greeting, the pages, all edits, the preview and the brush are to be said.
  void restart();

  /// The next message, or nothing.
  std::optional<ClientMessage> next();

  /// The edits were answered: they are forgotten, and returned. Nothing where none are known.
  std::optional<Batch> answered(const std::string& edit_id);
  /// The server forgets the preview: it is not said again.
  bool forget_preview(const std::string& edit_id);

  size_t unacknowledged() const;  ///< edits

  /// Returns whether the preview and the ends of earlier ones have been said.
  bool has_said_previews() const { return !must_drop() && (!gesture_ || gesture_->sent); }
  uint64_t previews_sent() const { return previews_sent_; }  ///< on this stream
  Time preview_since() const { return preview_since_; }      ///< of the newest part

 private:
  /// A preview under way.
  struct Gesture {
    Preview whole;
    size_t sent_points = 0;  // of a stroke
    bool sent = false;       // all of it was
  };

  Preview next_part(Gesture& gesture);
  /// A new preview replaces the one that the server has.
  bool must_drop() const { return !gesture_ && !begun_preview_.empty(); }

  const Greeting greeting_;
  bool greeted_ = false;
  PagesToShow pages_;
  std::deque<Batch> batches_;
  std::optional<Gesture> gesture_;
  std::string begun_preview_;  // that the server has a part of; empty: none
  std::optional<BrushRing> ring_;
  bool ring_sent_ = true;
  uint64_t previews_sent_ = 0;
  Time preview_since_;
};

}  // namespace burnish

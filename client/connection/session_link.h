#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "client/connection/live_news.h"
#include "common/base/clock.h"
#include "common/edit/edit.h"
#include "common/pages/directory.h"

namespace burnish {

struct LiveOptions {
  Greeting greeting;
  PageHead head;                   ///< of the scan's pages
  int depth = 0;                   ///< of the session
  uint64_t pages_fingerprint = 0;  ///< pages_fingerprint() of the encoded head; 0: not checked
  /// Between two pictures; frames are asked for so that they come just before the next one.
  std::chrono::microseconds draw_interval{16'667};
  /// Called from a thread of the session's own when there is something to take. Must not block.
  std::function<void()> on_news;

  std::chrono::milliseconds heartbeat_interval{1000};
  std::chrono::milliseconds silence_max{15'000};  ///< the server is taken for gone after that
  std::chrono::milliseconds retry_after_min{100};
  std::chrono::milliseconds retry_after_max{3000};
  Clock clock = std::chrono::steady_clock::now;
};

/// A client's end of a live session: edits in, frames and news out. It keeps itself connected, and
/// every edit until the server has it on disk or refuses it. All calls return at once, but for the
/// waits that say so. Thread-safe.
class SessionLink {
 public:
  /// Begins to connect, by a connection of its own: what else is fetched does not hold up frames.
  SessionLink(const Connection& connection, LiveOptions options);
  /// Edits that are not acknowledged are given up; see wait_until_acknowledged().
  ~SessionLink();

  /// Sends edits, all of them or none to take effect. What becomes of them is told by events.
  /// Fails: invalid_argument as validate(Edit) does, for none or more than kEditsPerFrameMax edits,
  /// and for cell fields, which go through Connection::apply(); failed_precondition when the
  /// session has ended.
  Status apply(std::vector<Edit> edits);

  /// Shows everybody what the edit `edit_id` would do if it were applied now. The path of a
  /// stroke goes on where the last part's ended. Another preview replaces it, and so does the edit
  /// itself.
  void preview(const std::string& edit_id, PreviewChange change);
  void drop_preview(const std::string& edit_id);

  /// Where this person's brush is; nothing: it left the surface.
  void move_brush(const std::optional<BrushRing>& ring);

  /// Changes the pages that frames carry; at first there are none. They are kept until they are
  /// removed, and told to every new stream. Needs: pages as decode_page() made them.
  /// Fails, and changes nothing: as ShownPages::check().
  Status show_pages(std::vector<std::shared_ptr<const Page>> added, std::vector<PageId> removed);

  /// What is new. To be called once per picture, just before it is drawn: more frames are asked
  /// for then.
  LiveNews take();

  /// Waits until no edit is under way. False when `patience` is over or the session has ended.
  bool wait_until_acknowledged(std::chrono::milliseconds patience);

  class Worker;

 private:
  std::unique_ptr<Worker> worker_;
};

}  // namespace burnish

#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/live/live_news.h"
#include "common/base/clock.h"
#include "common/base/status.h"
#include "common/edit/edit.h"
#include "common/pages/directory.h"
#include "common/service/live.h"

namespace burnish {

struct LiveOptions {
  Greeting greeting;
  PageHead head;                   ///< of the scan's pages
  int depth = 0;                   ///< of the session
  uint64_t pages_fingerprint = 0;  ///< pages_fingerprint() of the encoded head; 0: not checked
  /// Between two pictures; frames are asked for so that they come just before the next one.
  std::chrono::microseconds draw_interval{16'667};
  /// Called, from any thread, when there is something to take. Must not block.
  std::function<void()> on_news;

  std::chrono::milliseconds heartbeat_interval{1000};
  std::chrono::milliseconds silence_max{15'000};  ///< the server is taken for gone after that
  std::chrono::milliseconds retry_after_min{100};
  std::chrono::milliseconds retry_after_max{3000};
  Clock clock = std::chrono::steady_clock::now;
};

/// A client's end of a live session: edits in, frames and news out. It keeps itself connected, and
/// every edit until the server has it on disk or refuses it. All calls return at once.
class LiveLink {
 public:
  LiveLink() = default;
  /// Edits that are not acknowledged are given up.
  virtual ~LiveLink() = default;
  LiveLink(const LiveLink&) = delete;
  LiveLink& operator=(const LiveLink&) = delete;

  /// Sends edits, all of them or none to take effect. What becomes of them is told by events.
  /// Fails: invalid_argument as validate(Edit) does, for none or more than kEditsPerFrameMax edits,
  /// and for cell fields, which go through Connection::apply(); failed_precondition when the
  /// session has ended.
  virtual Status apply(std::vector<Edit> edits) = 0;

  /// Shows everybody what the edit `edit_id` would do if it were applied now. The path of a
  /// stroke goes on where the last part's ended. Another preview replaces it, and so does the edit
  /// itself.
  virtual void preview(const std::string& edit_id, PreviewChange change) = 0;
  virtual void drop_preview(const std::string& edit_id) = 0;

  /// Tells the place of this person's brush; nothing: it left the surface.
  virtual void move_brush(const std::optional<BrushRing>& ring) = 0;

  /// Changes the pages that frames carry; at first there are none. They are kept until they are
  /// removed, and told to every new stream. Needs: pages as decode_page() made them.
  /// Fails, and changes nothing: as PagesToShow::change().
  virtual Status show_pages(std::vector<std::shared_ptr<const Page>> added,
                            std::vector<PageId> removed) = 0;

  /// Returns what is new. To be called once per picture, just before it is drawn: more frames are
  /// asked for then. `draws`: otherwise no picture follows, and nothing is asked for.
  virtual LiveNews take(bool draws) = 0;
  LiveNews take() { return take(true); }

  /// A picture took so long. The next frame is asked for so that it comes when this time is over,
  /// if that is longer than LiveOptions::draw_interval.
  virtual void on_picture(std::chrono::microseconds took) = 0;
};

}  // namespace burnish

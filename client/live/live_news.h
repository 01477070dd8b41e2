#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "client/live/surface_frame.h"
#include "common/service/live.h"

namespace burnish {

// The news of a live session, taken once per drawn picture (SessionLink::take).

enum class LinkState {
  kConnecting,  ///< for the first time
  kLive,
  kLost,   ///< coming back by itself; edits are kept until then
  kEnded,  ///< for good: the reason says why
};

/// "connecting", "live", "lost", "ended".
const char* link_state_name(LinkState state);

/// How the link does.
struct LinkStats {
  FrameStats frame;     ///< of the newest frame
  uint64_t frames = 0;  ///< since the session was made; 0: nothing else here means anything
  /// Age of the newest frame when it was decoded: from the newest heartbeat that the server had
  /// when it made the frame, less half a round trip. Too long by the time between two heartbeats at
  /// most.
  double age_ms = 0;
  double waited_ms = 0;  ///< from then until it was taken
  double rtt_ms = 0;     ///< of the last heartbeat
  double frames_per_second = 0;
  double megabits_per_second = 0;
  uint64_t bytes = 0;     ///< of all frames so far
  int credit_window = 1;  ///< frames that may be on their way at once
  /// A frame of so many bytes takes the link no longer than FrameBudget::kTransferMs; 0: unknown.
  uint32_t frame_bytes_max = 0;
};

struct LinkChanged {
  LinkState state = LinkState::kConnecting;
  std::string reason;      ///< why it was lost or ended
  bool has_moved = false;  ///< it was lost because another server has the session: it goes on there
};

/// The first frame that has them is here: what was shown in their stead can go.
struct EditsShown {
  std::vector<std::string> edit_ids;
  double latency_ms = 0;  ///< since apply()
};

/// The newest part of a preview that a frame shows.
struct PreviewShown {
  double latency_ms = 0;  ///< since preview()
};

using LiveEvent = std::variant<LinkChanged, ProgressReport, Welcome, EditsAcknowledged,
                               EditsRefused, EditsShown, PreviewShown, HistoryState, SessionPeople>;

struct LiveNews {
  LinkState link = LinkState::kConnecting;
  /// The newest; null before the first.
  std::shared_ptr<const SurfaceFrame> frame;
  LinkStats stats;
  std::vector<LiveEvent> events;  ///< in order; of what replaces itself the newest only
  size_t unacknowledged = 0;      ///< edits
  /// How often the server ended the stream because it had no memory for the shown pages.
  uint64_t pages_refused = 0;
  /// The newest frame has seen all previews of this link, and the ends of those that were dropped.
  bool shows_previews = true;
};

}  // namespace burnish

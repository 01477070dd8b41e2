#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/frame_codec/frame_layout.h"
#include "common/frame_codec/frame_state.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"

namespace burnish {

// What a live session has to tell, taken once per drawn picture (SessionLink::take).

enum class LinkState {
  kConnecting,  ///< for the first time
  kLive,
  kLost,   ///< coming back by itself; edits are kept until then
  kEnded,  ///< for good: the reason says why
};

/// "connecting", "live", "lost", "ended".
const char* link_state_name(LinkState state);

/// Where the surface is. Values follow write_displacement().
struct Displacement {
  std::shared_ptr<const FrameLayout> layout;
  FrameState state;
  std::vector<int> changed_tiles;  ///< since the one that was taken before; rising
};

/// What the newest frame was told with, and how the link does.
struct FrameFigures {
  uint64_t frames = 0;  ///< since the session was made; 0: there is nothing below
  bool settled = false;
  bool exact = false;  ///< settled, and to the bar of exports
  int cycles = 0;      ///< since the session came into the server's memory
  double energy = 0;
  double residual = 0;
  double distance = 0;  ///< estimated to the converged surface, over the box's diagonal
  uint64_t edits = 0;   ///< of the session that the frame has seen
  double assemble_ms = 0;
  double solve_ms = 0;
  double encode_ms = 0;
  /// Since it was made, when it was decoded: from the newest heartbeat that the server had then,
  /// less half a round trip. Over-told by the time between two heartbeats at most.
  double age_ms = 0;
  double waited_ms = 0;  ///< from then until it was taken
  double rtt_ms = 0;     ///< of the last heartbeat
  double frames_per_second = 0;
  double megabits_per_second = 0;
  uint64_t bytes = 0;     ///< of all frames so far
  int credit_window = 1;  ///< frames that may be on their way at once
};

struct LinkChanged {
  LinkState state = LinkState::kConnecting;
  std::string reason;  ///< why it was lost or ended
};

struct Welcomed {
  SessionInfo session;
  uint64_t connection = 0;  ///< as in PresentUser
  SessionRole role = SessionRole::kViewer;
  std::string backend;
};

/// On disk.
struct AcknowledgedEdits {
  std::vector<std::string> edit_ids;
  ApplyOutcome outcome;
};

/// Not applied, and not kept. Ids of edits, or of a preview.
struct RefusedEdits {
  std::vector<std::string> edit_ids;
  Status why;
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

struct PeopleChanged {
  SessionPeople people;
};

struct HistoryChanged {
  uint64_t edits = 0;
  double gradient_scale = kBetaDefault;
  TransferCurve transfer_curve{kAlphaDefault};
};

/// The session is brought back into the server's memory.
struct ProgressMade {
  std::string phase;
  double fraction = 0;
};

using LiveEvent = std::variant<LinkChanged, Welcomed, AcknowledgedEdits, RefusedEdits, EditsShown,
                               PreviewShown, PeopleChanged, HistoryChanged, ProgressMade>;

struct LiveNews {
  LinkState link = LinkState::kConnecting;
  std::optional<Displacement> displacement;  ///< where it has changed since the last time
  FrameFigures facts;
  std::vector<LiveEvent> events;  ///< in order; of what replaces itself the newest only
  size_t unacknowledged = 0;      ///< edits
};

}  // namespace burnish

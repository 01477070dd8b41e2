#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/base/record.h"
#include "common/base/server_place.h"
#include "common/base/status.h"
#include "common/edit/edit.h"
#include "common/page_frames/page_kind.h"
#include "common/pages/page.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"

namespace burnish {

// The messages of a live session's stream: how it begins, what the client says, what the server
// says. docs/protocol.md, section 5, tells how they follow each other.

/// From the client, first and once.
struct Greeting {
  std::string session;                ///< name or id
  std::optional<PageFrameKind> kind;  ///< of all frames; nothing: the server chooses
  bool knows_held = true;             ///< the client knows held vertices of frames
};

/// From the server, while it brings the session back into its memory.
struct ProgressReport {
  std::string phase;    ///< in a few words
  double fraction = 0;  ///< of the phase, 0 to 1
};

/// From the server, once: the client is in the session.
struct Welcome {
  SessionInfo session;
  uint64_t connection = 0;                  ///< as in PresentUser
  SessionRole role = SessionRole::kViewer;  ///< of this client in this session
  uint64_t pages_fingerprint = 0;           ///< pages_fingerprint() of the scan's pages
  std::string backend;                      ///< that solves: "cpu", "cuda"
  std::vector<std::string> fleet;           ///< addresses of all servers of the fleet; empty: none
};
BURNISH_RECORD(Welcome, connection, pages_fingerprint, backend, fleet)

/// Credits that the server keeps for one client, frames.
inline constexpr uint32_t kCreditsMax = 8;

/// Frames that one credit message names as decoded, and as refused.
inline constexpr size_t kCreditNamesMax = 256;

/// Allows frames, and tells what became of those before.
struct FrameCredit {
  uint32_t frames = 0;            ///< more of them
  std::vector<uint64_t> decoded;  ///< sequence numbers of frames that the client now holds
  std::vector<uint64_t> refused;  ///< sequence numbers of frames whose reference it does not hold
  bool key_frame = false;         ///< the client holds no frame
  uint32_t frame_bytes = 0;       ///< wanted at most while the surface moves; 0: any size
};
BURNISH_RECORD(FrameCredit, frames, decoded, refused, key_frame, frame_bytes)

/// Changes the pages that the client shows. A stream begins with revision 0, which shows nothing.
struct ShowPages {
  uint32_t revision = 0;  ///< one more than the last one
  std::vector<PageId> added;
  std::vector<PageId> removed;
};
BURNISH_RECORD(ShowPages, revision, added, removed)

/// Edits that take effect together or not at all: 1 to kEditsPerFrameMax.
struct ApplyEdits {
  std::vector<Edit> edits;
};

/// A gesture's next piece. The path of a stroke goes on where the last piece ended.
struct Preview {
  std::string edit_id;  ///< of the edit that will follow
  PreviewChange change;
};

/// Ends a preview without an edit.
struct DropPreview {
  std::string edit_id;
};

/// Tells where the client's brush is.
struct MoveBrush {
  std::optional<BrushRing> ring;  ///< nothing: the brush left the surface
};

/// From the client, and back from the server as it is.
struct Heartbeat {
  uint64_t client_time_us = 0;  ///< by the client's own clock
};

using ClientMessage = std::variant<Greeting, FrameCredit, ApplyEdits, Preview, DropPreview,
                                   MoveBrush, Heartbeat, ShowPages>;

/// Describes the surface that a frame shows, and what it took to make the frame.
struct FrameStats {
  bool settled = false;  ///< to the bar of a live session: no frame follows until something changes
  bool exact = false;    ///< settled, and solved to the bar of exports; the frame is rounded
  int cycles = 0;        ///< since the session came into the server's memory
  double energy = 0;     ///< of the screened Poisson equation, grid units
  double residual = 0;   ///< relative
  double distance = 0;   ///< estimated to the converged surface, over the box's diagonal
  uint64_t edits = 0;    ///< of the session, that the frame has seen
  double assemble_ms = 0;
  double solve_ms = 0;
  double encode_ms = 0;
  uint64_t client_time_us = 0;  ///< of the newest heartbeat that the frame has seen; 0: none
  uint64_t previews = 0;        ///< messages of this client that the frame has seen
  double held_ms = 0;           ///< from the coming of that heartbeat until the frame went out
  double volume = 0;            ///< over the scan's, if the controls keep it; else 0
};
BURNISH_RECORD(FrameStats, exact, cycles, energy, residual, distance, edits, assemble_ms, solve_ms,
               encode_ms, client_time_us, previews, held_ms, volume)

struct LiveFrame {
  std::string data;  ///< in the frame format; empty: nothing has moved since the last frame
  FrameStats stats;
};

/// The edits of one message are on disk.
struct EditsAcknowledged {
  std::vector<std::string> edit_ids;
  ApplyOutcome outcome;
};

/// The edits of one message, or a preview, are not applied and not kept.
struct EditsRefused {
  std::vector<std::string> edit_ids;
  Status status;  ///< kUnavailable: the same edits are to be sent again after the next welcome
};

/// The values that the session's history comes to. SessionPeople says who is there.
struct HistoryState {
  uint64_t edits = 0;  ///< of the session
  Settings settings;
  bool operator==(const HistoryState&) const = default;
};

/// Says why a stream ends.
enum class GoAwayCode {
  kUnknown,       ///< of a server that knows no codes, or knows others
  kGoingDown,     ///< the server ends
  kSilent,        ///< the client has sent nothing for too long
  kClosed,        ///< an owner has closed or deleted the session
  kRemoved,       ///< the user may not be on the server any more
  kTooManyPages,  ///< the server has no memory for the pages that the client shows
  kDamagedPages,  ///< the page file is damaged
  kFailed,        ///< a fault of the server, or no memory for the session
  kNotOwner,      ///< another server of the fleet may have the session
};

/// The last message.
struct GoAway {
  GoAwayCode code = GoAwayCode::kUnknown;
  std::string reason;      ///< in words
  bool come_back = false;  ///< greet again after a pause
  /// Has the session, or is to take it: greet there at once.
  std::optional<ServerPlace> moved_to{};
  std::vector<std::string> fleet{};  ///< takes the place of the welcome's, unless it is empty
};

using ServerMessage = std::variant<ProgressReport, Welcome, LiveFrame, EditsAcknowledged,
                                   EditsRefused, HistoryState, SessionPeople, Heartbeat, GoAway>;

}  // namespace burnish

#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "common/service/session_info.h"
#include "common/service/session_people.h"
#include "server/session/previews.h"
#include "server/solver/solver.h"

namespace burnish {

// What a client of a live session is told, and what it asks for, in the terms of this program;
// proto/burnish/v1/editing.proto says what each means.

inline constexpr uint32_t kCreditsMax = 8;

/// More frames, and what became of those before.
struct FrameCredit {
  uint32_t frames = 0;
  std::vector<uint64_t> decoded;
  std::vector<uint64_t> refused;
  bool key_frame = false;
  uint32_t frame_bytes = 0;  ///< wanted at most while the surface moves; 0: any
};

/// A gesture's next piece; of a stroke the path goes on where the last one ended.
struct PreviewPiece {
  std::string edit_id;
  std::variant<SetGradientScale, SetTransferCurve, Stroke> change;
};

/// What a frame is told with.
struct FrameFacts {
  bool settled = false;
  bool exact = false;  ///< settled, and to the bar of exports
  StepReport report;
  uint64_t edits = 0;  ///< of the session, that the frame has seen
  double assemble_ms = 0;
  double solve_ms = 0;
  double encode_ms = 0;
  uint64_t client_time_us = 0;
  uint64_t previews = 0;
  double held_ms = 0;  ///< since the heartbeat of client_time_us came
};

struct LiveFrame {
  std::string data;  ///< in the frame format; empty: nothing has moved since the last one
  FrameFacts facts;
};

struct EditsAcknowledged {
  std::vector<std::string> edit_ids;
  ApplyOutcome outcome;
};

struct EditsRefused {
  std::vector<std::string> edit_ids;
  Status status;
};

struct HistoryState {
  uint64_t edits = 0;
  double gradient_scale = kBetaDefault;
  TransferCurve transfer_curve{kAlphaDefault};
  bool operator==(const HistoryState&) const = default;
};

struct HeartbeatEcho {
  uint64_t client_time_us = 0;
};

/// The last thing that a client is told.
struct Farewell {
  std::string reason;
  bool come_back = false;
};

using LiveMessage = std::variant<LiveFrame, EditsAcknowledged, EditsRefused, SessionPeople,
                                 HistoryState, HeartbeatEcho, Farewell>;

}  // namespace burnish

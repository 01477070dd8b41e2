#pragma once

#include <vector>

#include "burnish/v1/editing.pb.h"
#include "server/live/live_sessions.h"

namespace burnish {

// The messages of live sessions, to and from the wire. Every value is checked here.

/// 1 to kEditsPerFrameMax edits. Fails: invalid_argument naming the edit, the value and its limit.
Result<std::vector<Edit>> edits_from_wire(
    const google::protobuf::RepeatedPtrField<v1::Edit>& messages);

/// Fails: invalid_argument.
Result<LiveGreeting> from_wire(const v1::Greeting& message);
Result<FrameCredit> from_wire(const v1::Credit& message);

/// Needs: not a drop. Fails: invalid_argument.
Result<PreviewPiece> from_wire(const v1::Preview& message);

/// Nothing when the brush has left the surface. Fails: invalid_argument.
Result<std::optional<BrushRing>> from_wire(const v1::MoveBrush& message);

v1::ServerMessage to_wire(const LiveClient& welcome);
v1::ServerMessage to_wire(LiveMessage message);

}  // namespace burnish

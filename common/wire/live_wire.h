#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/v1/editing.pb.h"
#include "common/service/live.h"

namespace burnish {

// The messages of a live session's stream. Every value that can be checked without the session is
// checked here.

v1::ClientMessage to_wire(const ClientMessage& message);

/// Fails: invalid_argument naming the value and its limit, or for a kind of message that this
/// program does not know.
Result<ClientMessage> from_wire(const v1::ClientMessage& message);

v1::Greeting to_wire(const Greeting& greeting);
/// Fails: invalid_argument for an unknown kind of frames; failed_precondition for a client that
/// does not know pages.
Result<Greeting> from_wire(const v1::Greeting& message);

/// Returns the ids that a refusal of the message names: of its edits, or of its preview. Leaves out
/// ids above kEditIdBytesMax, and those after the first kEditsPerFrameMax.
std::vector<std::string> refused_ids(const v1::ClientMessage& message);

v1::ServerMessage to_wire(ServerMessage message);

/// Returns nothing for a kind of message that this program does not know: the server is newer.
/// Fails: invalid_argument naming the value, for a content, a role, a curve or a session's depth
/// and radius that this program does not know.
Result<std::optional<ServerMessage>> from_wire(v1::ServerMessage message);

}  // namespace burnish

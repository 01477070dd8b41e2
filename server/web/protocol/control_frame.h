#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "common/base/status.h"

namespace burnish {

/// The text frames of the subprotocol burnish.v1: JSON objects of a client, and the gateway's
/// answer.

/// {"call": "burnish.v1.Editing/Edit", "token": "...", "user": "anna"}: begins a call.
struct CallFrame {
  std::string method;               ///< "/burnish.v1.Editing/Edit", as gRPC has it
  std::string token;                ///< empty for none
  std::optional<std::string> user;  ///< the name of a caller without authentication
  bool operator==(const CallFrame&) const = default;
};
/// {"end": true}: the client sends no further message.
struct EndFrame {
  bool operator==(const EndFrame&) const = default;
};
/// {"cancel": true}
struct CancelFrame {
  bool operator==(const CancelFrame&) const = default;
};
using ControlFrame = std::variant<CallFrame, EndFrame, CancelFrame>;

/// Fails: invalid_argument that names the key or the limit; the text itself is in no message, for
/// it may have a token.
Result<ControlFrame> read_control_frame(std::string_view text);

/// Returns {"code":5,"message":"..."}, which ends a call. `code` is gRPC's number. `details` are
/// gRPC's too, and become "details" in hexadecimal; empty: there are none.
std::string end_of_call_frame(int code, std::string_view message, std::string_view details = {});

}  // namespace burnish

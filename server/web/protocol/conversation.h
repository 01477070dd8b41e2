#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "server/web/protocol/control_frame.h"
#include "server/web/protocol/web_limits.h"

namespace burnish {

/// The codes of WebSocket's close frames that the gateway sends (RFC 6455, section 7.4).
enum class CloseCode : uint16_t {
  kGoingAway = 1001,
  kProtocolError = 1002,
  kTooBig = 1009,
};

/// Orders to the gateway. Each frame of a client gives one.
struct StartCall {
  CallFrame call;
};
struct PassMessage {};  ///< the frame goes to the call
struct EndMessages {};
struct CancelCall {};
struct DropFrame {};  ///< the frame belongs to a call that has ended meanwhile
struct CloseSocket {
  CloseCode code;
  std::string reason;  ///< at most 123 bytes
};
using Order = std::variant<StartCall, PassMessage, EndMessages, CancelCall, DropFrame, CloseSocket>;

/// The rules of one socket: calls come one after the other. Knows neither sockets nor gRPC. After
/// CloseSocket it takes no further frame.
class Conversation {
 public:
  /// Takes a text frame.
  Order hear_text(std::string_view text);

  /// Takes a binary frame, or the begin of one that is too long: above `bytes_max`.
  Order hear_message(size_t bytes, size_t bytes_max = kWebMessageBytesMax);

  /// Notes that the call has ended, or was refused. Needs: is_calling().
  void note_end();

  /// Returns whether the next message goes to a call. If not, hear_message() needs none of its
  /// bytes.
  bool takes_messages() const { return state_ == State::kOpen; }

  /// Returns whether a call runs.
  bool is_calling() const { return state_ != State::kFresh && state_ != State::kBetween; }

 private:
  enum class State {
    kFresh,      // no call yet
    kOpen,       // the client may send
    kHalf,       // the client has said that it sends nothing more
    kCancelled,  // the gateway waits for the call's end
    kBetween,    // a call has ended; late frames of it may come
  };

  Order obey(const CallFrame& call);
  Order obey(const EndFrame&);
  Order obey(const CancelFrame&);

  State state_ = State::kFresh;
};

}  // namespace burnish

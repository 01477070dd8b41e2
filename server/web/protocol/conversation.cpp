#include "server/web/protocol/conversation.h"

#include "common/base/check.h"
#include "common/base/text.h"

namespace burnish {

static constexpr size_t kReasonBytesMax = 90;  // "... (12345 more bytes)" follows

static Order protocol_error(std::string_view why) {
  return CloseSocket{CloseCode::kProtocolError, shortened(why, kReasonBytesMax)};
}

Order Conversation::hear_text(std::string_view text) {
  const auto frame = read_control_frame(text);
  if (!frame.is_ok()) return protocol_error(frame.status().message());
  return std::visit([this](const auto& read) { return obey(read); }, *frame);
}

Order Conversation::hear_message(size_t bytes, size_t bytes_max) {
  if (bytes > bytes_max)
    return CloseSocket{CloseCode::kTooBig,
                       "a message has more than " + std::to_string(bytes_max) + " bytes"};
  switch (state_) {
    case State::kFresh:
      return protocol_error("a message before the first call");
    case State::kHalf:
      return protocol_error("a message after the messages' end");
    case State::kOpen:
      return PassMessage{};
    case State::kCancelled:
    case State::kBetween:
      break;
  }
  return DropFrame{};
}

void Conversation::note_end() {
  BURNISH_CHECK(is_calling(), "no call runs");
  state_ = State::kBetween;
}

Order Conversation::obey(const CallFrame& call) {
  if (is_calling()) return protocol_error("a call begins while another runs");
  state_ = State::kOpen;
  return StartCall{call};
}

Order Conversation::obey(const EndFrame&) {
  switch (state_) {
    case State::kFresh:
      return protocol_error("an end before the first call");
    case State::kHalf:
      return protocol_error("a second end of the messages");
    case State::kOpen:
      state_ = State::kHalf;
      return EndMessages{};
    case State::kCancelled:
    case State::kBetween:
      break;
  }
  return DropFrame{};
}

Order Conversation::obey(const CancelFrame&) {
  if (state_ == State::kFresh) return protocol_error("a cancel before the first call");
  if (state_ != State::kOpen && state_ != State::kHalf) return DropFrame{};
  state_ = State::kCancelled;
  return CancelCall{};
}

}  // namespace burnish

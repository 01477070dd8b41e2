#include <algorithm>
#include <string>

#include "common/base/check.h"
#include "common/base/text.h"
#include "server/web/protocol/conversation.h"
#include "server/web/protocol/request_rules.h"
#include "server/web/protocol/web_limits.h"
#include "tests/fuzz/readers.h"

namespace burnish {
namespace {

constexpr size_t kCloseReasonBytesMax = 123;  // RFC 6455, section 5.5

/// Holds each order to what the gateway relies on.
struct OrderCheck {
  bool was_calling;
  bool is_calling;

  void operator()(const StartCall& order) const {
    BURNISH_CHECK(!was_calling && is_calling, "a call begins beside another");
    BURNISH_CHECK(order.call.method.starts_with('/'), "a method without its slash");
    const auto is_legal = [](char c) { return c >= ' ' && c <= '~'; };
    BURNISH_CHECK(std::ranges::all_of(order.call.token, is_legal), "gRPC would end the process");
    BURNISH_CHECK(order.call.token.size() <= kWebTokenBytesMax, "a token is too long");
    BURNISH_CHECK(is_valid_utf8(order.call.user.value_or("")), "a name is not UTF-8");
  }
  void operator()(const PassMessage&) const { check_running(); }
  void operator()(const EndMessages&) const { check_running(); }
  void operator()(const CancelCall&) const { check_running(); }
  void operator()(const DropFrame&) const {}
  void operator()(const CloseSocket& order) const {
    BURNISH_CHECK(order.reason.size() <= kCloseReasonBytesMax, "a close frame is too long");
    BURNISH_CHECK(is_valid_utf8(order.reason), "a close frame is not UTF-8");
  }

 private:
  void check_running() const { BURNISH_CHECK(was_calling && is_calling, "no call runs"); }
};

/// Takes a frame's kind, length and bytes from the front.
struct FuzzedFrame {
  explicit FuzzedFrame(std::span<const uint8_t>& rest) : kind(rest[0] % 4) {
    length = static_cast<size_t>(rest[1] | rest[2] << 8);
    const size_t carried = kind < 2 ? std::min(length, rest.size() - 3) : 0;
    bytes.assign(rest.begin() + 3, rest.begin() + 3 + static_cast<ptrdiff_t>(carried));
    rest = rest.subspan(3 + carried);
  }
  int kind;
  size_t length;
  std::string bytes;
};

}  // namespace

bool read_web_frames(std::span<const uint8_t> bytes) {
  Conversation conversation;
  while (bytes.size() >= 3) {
    const FuzzedFrame frame(bytes);
    if (frame.kind == 3) {
      if (conversation.is_calling()) conversation.note_end();
      continue;
    }
    const bool was_calling = conversation.is_calling();
    const Order order = frame.kind == 0   ? conversation.hear_text(frame.bytes)
                        : frame.kind == 1 ? conversation.hear_message(frame.bytes.size())
                                          : conversation.hear_message(frame.length << 10);
    std::visit(OrderCheck{was_calling, conversation.is_calling()}, order);
    if (std::holds_alternative<CloseSocket>(order)) return false;
  }
  return true;
}

bool read_web_request(std::span<const uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const size_t line = std::min(text.find('\n'), text.size());
  const std::string_view host = text.substr(0, line);
  const std::string_view origin = text.substr(std::min(line + 1, text.size()));
  const RequestRules rules{{"burnish.lab"}, true};
  const bool is_host = check_host(rules, host, "10.0.0.7").is_ok();
  const bool is_origin = check_origin(rules, origin, host).is_ok();
  BURNISH_CHECK(!is_host || host.find_first_of("/ @\\") == std::string_view::npos,
                "a host with more than a name");
  BURNISH_CHECK(!is_origin || origin.empty() || origin.size() == host.size() + 8,
                "an origin that is not the host's");
  return is_host && is_origin;
}

}  // namespace burnish

#include "server/web/protocol/control_frame.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "common/base/text.h"
#include "server/web/protocol/web_limits.h"

namespace burnish {
namespace {

using nlohmann::json;

Status wrong(const std::string& what) {
  return invalid_argument("control frame: " + what);
}

/// gRPC ends the process over a header with other characters.
bool is_header_text(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

Result<std::string> read_text(const json& frame, const char* key) {
  const json& value = frame.at(key);
  if (!value.is_string()) return wrong(std::string("'") + key + "' is not a string");
  return value.get<std::string>();
}

Status check_keys(const json& frame, std::initializer_list<std::string_view> keys) {
  for (const auto& [key, value] : frame.items())
    if (std::ranges::find(keys, key) == keys.end()) return wrong("a key is not known");
  return Status::ok();
}

Result<ControlFrame> read_call(const json& frame) {
  RETURN_IF_ERROR(check_keys(frame, {"call", "token", "user"}));
  CallFrame call;
  ASSIGN_OR_RETURN(const std::string method, read_text(frame, "call"));
  call.method = "/" + method;
  if (!is_header_text(method)) return wrong("'call' has a character outside of ASCII");
  if (frame.contains("token")) {
    ASSIGN_OR_RETURN(call.token, read_text(frame, "token"));
  }
  if (frame.contains("user")) {
    ASSIGN_OR_RETURN(call.user, read_text(frame, "user"));
  }
  if (call.token.size() > kWebTokenBytesMax)
    return wrong("'token' has " + std::to_string(call.token.size()) + " bytes, the limit is " +
                 std::to_string(kWebTokenBytesMax));
  if (!is_header_text(call.token)) return wrong("'token' has a character outside of ASCII");
  return ControlFrame(std::move(call));
}

template <typename Frame>
Result<ControlFrame> read_mark(const json& frame, const char* key) {
  RETURN_IF_ERROR(check_keys(frame, {key}));
  if (frame.at(key) != json(true)) return wrong(std::string("'") + key + "' is not true");
  return ControlFrame(Frame{});
}

}  // namespace

Result<ControlFrame> read_control_frame(std::string_view text) {
  if (text.size() > kWebControlBytesMax)
    return wrong(std::to_string(text.size()) + " bytes, the limit is " +
                 std::to_string(kWebControlBytesMax));
  const json frame = json::parse(text, nullptr, false);
  if (!frame.is_object()) return wrong("not a JSON object");
  if (frame.contains("call")) return read_call(frame);
  if (frame.contains("end")) return read_mark<EndFrame>(frame, "end");
  if (frame.contains("cancel")) return read_mark<CancelFrame>(frame, "cancel");
  return wrong("none of the keys 'call', 'end' and 'cancel'");
}

std::string end_of_call_frame(int code, std::string_view message, std::string_view details) {
  nlohmann::ordered_json frame = {{"code", code}, {"message", message}};
  if (!details.empty()) frame["details"] = to_hex(std::as_bytes(std::span(details)));
  return frame.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace burnish

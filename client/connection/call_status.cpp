#include <algorithm>
#include <cstdio>
#include <iterator>

#include "client/connection/connection_state.h"
#include "common/wire/status_wire.h"

namespace burnish {

namespace {

/// A text of gRPC or of the system, and what it means to a user.
struct Meaning {
  std::string_view part;
  std::string_view words;
};

// The first one that fits counts.
constexpr Meaning kNoLink[] = {
    {"certificate verify failed", "its certificate is not of an authority that is trusted here"},
    {"Peer name", "its certificate is for another name"},
    {"wrong version number", "it does not speak TLS, or is not a Burnish server"},
    {"handshake failed", "the two ends do not agree on TLS"},
    {"http1.x", "it is not a Burnish server"},
    {"DNS resolution failed", "no computer has this name"},
    {"Connection refused", "nothing listens there; does burnish-server run?"},
    {"No such file", "its socket does not exist; does burnish-server run?"},
    {"Permission denied", "this user may not open its socket"},
    {"unreachable", "no network leads there"},
    {"No route", "no network leads there"},
    {"timed out", "it does not answer"},
    {"Deadline Exceeded", "it does not answer"},
    {"Socket closed", "it ends connections at once, as a server with TLS does to clients without"},
    {"reset by peer", "it ends connections at once"},
};

constexpr std::string_view kLostLink[] = {
    "Socket closed", "reset by peer", "Broken pipe",      "recvmsg",
    "sendmsg",       "GOAWAY",        "Stream removed",   "Endpoint",
    "keepalive",     "ping timeout",  "Transport closed", "Cancelling all calls"};

bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// The server's own texts stay as they are.
std::string unavailable_words(const std::string& text) {
  if (has(text, "failed to connect") || has(text, "DNS resolution failed"))
    return no_link_words(text);
  const auto is_part = [&](std::string_view part) { return has(text, part); };
  return std::ranges::any_of(kLostLink, is_part) ? "the connection is lost" : text;
}

}  // namespace

std::string no_link_words(std::string_view text) {
  const auto fits = [&](const Meaning& meaning) { return has(text, meaning.part); };
  const auto found = std::ranges::find_if(kNoLink, fits);
  return std::string(found == std::end(kNoLink) ? text : found->words);
}

/// Returns what a Moved says; empty for other details.
static ServerPlace place_in(const std::string& details) {
  v1::Moved moved;
  if (!moved.ParseFromString(details)) return {};
  return {moved.address(), moved.node()};
}

Status call_status(const std::string& server, const grpc::Status& status) {
  if (status.ok()) return Status::ok();
  const std::string where = "server " + server + ": ";
  const StatusCode code = status_code_from_wire(status.error_code());
  const ServerPlace moved_to = place_in(status.error_details());
  if (code == StatusCode::kFailedPrecondition && moved_to != ServerPlace())
    return Status::moved(moved_to.text(), where + status.error_message());
  if (code == StatusCode::kDeadlineExceeded) return {code, where + "no answer in time"};
  if (code == StatusCode::kUnavailable)
    return {code, where + unavailable_words(status.error_message())};
  if (code == StatusCode::kUnimplemented && status.error_message().empty())
    return {code, where + "it is of a version without this call"};
  return {code, where + status.error_message()};
}

}  // namespace burnish

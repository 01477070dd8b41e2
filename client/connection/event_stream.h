#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "client/connection/connection_state.h"
#include "common/base/progress.h"

namespace burnish {

template <typename Event>
using DoneOf = std::decay_t<decltype(std::declval<Event>().done())>;

/// Reads a call that tells its progress until it ends. Returns false if `progress` asks to cancel
/// it.
template <typename Event, typename Stream>
bool read_events(grpc::ClientContext& context, Stream& stream, const Progress& progress,
                 std::optional<DoneOf<Event>>& done) {
  Event event;
  bool is_cancelled = false;
  while (stream.Read(&event)) {
    if (event.has_done()) done = std::move(*event.mutable_done());
    if (is_cancelled || !event.has_progress()) continue;
    is_cancelled = !report(progress, event.progress().phase(), event.progress().fraction());
    if (is_cancelled) context.TryCancel();
  }
  return !is_cancelled;
}

/// Reads a call that tells its progress, up to its answer. `doing` is what the call does:
/// "describing the pages". Fails: cancelled if `progress` asks for it; as the server says;
/// data_loss without an answer.
template <typename Event, typename Stream>
Result<DoneOf<Event>> read_until_done(const std::string& server, grpc::ClientContext& context,
                                      Stream& stream, const Progress& progress,
                                      const std::string& doing) {
  std::optional<DoneOf<Event>> done;
  const bool is_heard = read_events<Event>(context, stream, progress, done);
  const grpc::Status there = stream.Finish();
  if (!is_heard) return cancelled(doing + " was cancelled");
  RETURN_IF_ERROR(call_status(server, there));
  if (!done) return data_loss("server " + server + " ended " + doing + " without an answer");
  return std::move(*done);
}

/// Reads a call while `take` returns that it wants more. Fails: as the server says; cancelled if
/// `take` wants no more.
template <typename Event, typename Stream, typename Take>
Status read_while_wanted(const std::string& server, grpc::ClientContext& context, Stream& stream,
                         const std::string& doing, const Take& take) {
  Event event;
  bool is_wanted = true;
  while (stream.Read(&event)) {
    if (is_wanted && !(is_wanted = take(event))) context.TryCancel();
  }
  const grpc::Status there = stream.Finish();
  if (!is_wanted) return cancelled(doing + " was cancelled");
  return call_status(server, there);
}

}  // namespace burnish

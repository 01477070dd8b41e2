// What SessionLink::Worker does with what the server says.

#include <algorithm>

#include "client/connection/live_worker.h"
#include "common/wire/live_wire.h"

namespace burnish {

// 0 for a time that is not one of ours.
static double ms_since(uint64_t client_time_us, SessionLink::Worker::Time now) {
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  const auto passed = us.count() - static_cast<int64_t>(client_time_us);
  return client_time_us == 0 || passed < 0 ? 0 : static_cast<double>(passed) / 1000;
}

Status SessionLink::Worker::hear(v1::ServerMessage message) {
  ASSIGN_OR_RETURN(auto heard, from_wire(std::move(message)));
  if (!heard) return Status::ok();  // of a newer server
  return std::visit([this](auto& said) { return hear(said); }, *heard);
}

Status SessionLink::Worker::hear(ProgressReport& report) {
  const std::lock_guard lock(mutex_);
  tell(std::move(report));
  return Status::ok();
}

Status SessionLink::Worker::hear(Welcome& welcome) {
  RETURN_IF_ERROR(receiver_.welcome(welcome));
  const std::lock_guard lock(mutex_);
  news_.link = LinkState::kLive;
  tell(LinkChanged{LinkState::kLive, {}});
  tell(std::move(welcome));
  return Status::ok();
}

Status SessionLink::Worker::hear(const LiveFrame& frame) {
  ASSIGN_OR_RETURN(auto surface, receiver_.receive(frame.data));
  const Time decoded = options_.clock();
  const FrameStats& made = frame.stats;
  const double server_ms = made.assemble_ms + made.solve_ms + made.encode_ms;
  const std::lock_guard lock(mutex_);
  LinkStats& stats = news_.stats;
  rate_.add(last_heard_, frame.data.size());
  stats.frame = made;
  ++stats.frames;
  const double since_heartbeat_ms = ms_since(made.client_time_us, decoded);
  stats.age_ms = std::max(0.0, since_heartbeat_ms - pacer_.rtt_ms() / 2);
  stats.bytes += frame.data.size();
  last_decoded_ = decoded;
  has_new_frame_ = true;
  const double link_ms = ms_since(made.client_time_us, last_heard_) - made.held_ms;
  pacer_.on_frame(decoded, std::max(0.0, link_ms), server_ms);
  if (link_ms > 0 && pacer_.rtt_ms() > 0)
    budget_.on_frame(frame.data.size(), link_ms - pacer_.rtt_ms());
  stats.credit_window = pacer_.window();
  shown_.frame(made.edits, made.previews, decoded);
  tell_shown();
  outbox_.pages().shown(receiver_.shown_revision());
  if (surface) news_.frame = std::move(surface);
  return Status::ok();
}

Status SessionLink::Worker::hear(EditsAcknowledged& answer) {
  const std::lock_guard lock(mutex_);
  if (answer.edit_ids.empty()) return Status::ok();
  if (const auto batch = outbox_.answered(answer.edit_ids.front())) {
    shown_.acknowledged(answer.edit_ids, batch->since, answer.outcome.edits);
    tell_shown();
  }
  tell(std::move(answer));
  acknowledged_.notify_all();
  return Status::ok();
}

Status SessionLink::Worker::hear(EditsRefused& answer) {
  // It cannot be kept now: the next stream brings it again.
  if (answer.status.code() == StatusCode::kUnavailable) {
    farewell_ = "server " + server_ + ": " + answer.status.message();
    leaving_ = true;
    return Status::ok();
  }
  const std::lock_guard lock(mutex_);
  if (answer.edit_ids.empty()) return Status::ok();
  const std::string& first = answer.edit_ids.front();
  if (!outbox_.answered(first)) outbox_.forget_preview(first);
  tell(std::move(answer));
  acknowledged_.notify_all();
  return Status::ok();
}

Status SessionLink::Worker::hear(HistoryState& history) {
  const std::lock_guard lock(mutex_);
  tell(std::move(history));
  return Status::ok();
}

Status SessionLink::Worker::hear(SessionPeople& people) {
  const std::lock_guard lock(mutex_);
  tell(std::move(people));
  return Status::ok();
}

Status SessionLink::Worker::hear(const Heartbeat& echo) {
  const double rtt_ms = ms_since(echo.client_time_us, last_heard_);
  if (rtt_ms <= 0) return Status::ok();
  const std::lock_guard lock(mutex_);
  news_.stats.rtt_ms = rtt_ms;
  pacer_.on_heartbeat(last_heard_, rtt_ms);
  return Status::ok();
}

Status SessionLink::Worker::hear(const Farewell& farewell) {
  if (!farewell.come_back) return failed_precondition(farewell.reason);
  farewell_ = "server " + server_ + ": " + farewell.reason;
  leaving_ = true;
  const std::lock_guard lock(mutex_);
  news_.pages_refused += farewell.code == FarewellCode::kTooManyPages;
  return Status::ok();
}

void SessionLink::Worker::tell_shown() {
  for (EditsShown& shown : shown_.take_edits()) tell(std::move(shown));
  for (const double latency_ms : shown_.take_previews()) tell(PreviewShown{latency_ms});
}

// Of what replaces itself the newest is enough, so that nobody who does not listen costs memory.
void SessionLink::Worker::tell(LiveEvent event) {
  const bool replaces = !std::holds_alternative<EditsAcknowledged>(event) &&
                        !std::holds_alternative<EditsRefused>(event) &&
                        !std::holds_alternative<EditsShown>(event);
  if (replaces)
    std::erase_if(news_.events,
                  [&](const LiveEvent& other) { return other.index() == event.index(); });
  news_.events.push_back(std::move(event));
}

}  // namespace burnish

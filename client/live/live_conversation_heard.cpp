// The part of LiveConversation that takes the server's messages.

#include <algorithm>

#include "client/live/live_conversation.h"

namespace burnish {

// 0 for a time that is not one of ours.
static double ms_since(uint64_t client_time_us, LiveConversation::Time now) {
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  const auto passed = us.count() - static_cast<int64_t>(client_time_us);
  return client_time_us == 0 || passed < 0 ? 0 : static_cast<double>(passed) / 1000;
}

bool LiveConversation::hear(Result<std::optional<ServerMessage>> said) {
  last_heard_ = options_.clock();
  if (!said.is_ok()) {
    failure_ = said.status();
    return true;
  }
  if (!*said) return false;  // of a newer server
  failure_ = std::visit([this](auto& message) { return take_in(message); }, **said);
  return !std::holds_alternative<Heartbeat>(**said);
}

Status LiveConversation::take_in(ProgressReport& report) {
  const LiveGuard lock(mutex_);
  tell(std::move(report));
  return Status::ok();
}

Status LiveConversation::take_in(Welcome& welcome) {
  RETURN_IF_ERROR(receiver_.welcome(welcome));
  route_->learn(welcome.fleet);
  const LiveGuard lock(mutex_);
  news_.link = LinkState::kLive;
  tell(LinkChanged{LinkState::kLive, {}});
  tell(std::move(welcome));
  return Status::ok();
}

Status LiveConversation::take_in(const LiveFrame& frame) {
  ASSIGN_OR_RETURN(auto surface, receiver_.receive(frame.data));
  const Time decoded = options_.clock();
  const FrameStats& made = frame.stats;
  const double server_ms = made.assemble_ms + made.solve_ms + made.encode_ms;
  const LiveGuard lock(mutex_);
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

Status LiveConversation::take_in(EditsAcknowledged& answer) {
  const LiveGuard lock(mutex_);
  if (answer.edit_ids.empty()) return Status::ok();
  if (const auto batch = outbox_.answered(answer.edit_ids.front())) {
    shown_.acknowledged(answer.edit_ids, batch->since, answer.outcome.edits);
    tell_shown();
  }
  tell(std::move(answer));
  return Status::ok();
}

Status LiveConversation::take_in(EditsRefused& answer) {
  // It cannot be kept now: the next stream brings it again.
  if (answer.status.code() == StatusCode::kUnavailable) {
    go_away_ = "server " + server_ + ": " + answer.status.message();
    return Status::ok();
  }
  const LiveGuard lock(mutex_);
  if (answer.edit_ids.empty()) return Status::ok();
  const std::string& first = answer.edit_ids.front();
  if (!outbox_.answered(first)) outbox_.forget_preview(first);
  tell(std::move(answer));
  return Status::ok();
}

Status LiveConversation::take_in(HistoryState& history) {
  const LiveGuard lock(mutex_);
  tell(std::move(history));
  return Status::ok();
}

Status LiveConversation::take_in(SessionPeople& people) {
  const LiveGuard lock(mutex_);
  tell(std::move(people));
  return Status::ok();
}

Status LiveConversation::take_in(const Heartbeat& echo) {
  const double rtt_ms = ms_since(echo.client_time_us, last_heard_);
  if (rtt_ms <= 0) return Status::ok();
  const LiveGuard lock(mutex_);
  news_.stats.rtt_ms = rtt_ms;
  pacer_.on_heartbeat(last_heard_, rtt_ms);
  return Status::ok();
}

Status LiveConversation::take_in(const GoAway& go_away) {
  if (!go_away.come_back) return failed_precondition(go_away.reason);
  go_away_ = "server " + server_ + ": " + go_away.reason;
  if (!go_away.fleet.empty()) route_->learn(go_away.fleet);
  if (go_away.moved_to) return Status::moved(go_away.moved_to->text(), go_away_);
  has_server_lost_it_ =
      go_away.code == GoAwayCode::kGoingDown || go_away.code == GoAwayCode::kNotOwner;
  const LiveGuard lock(mutex_);
  news_.pages_refused += go_away.code == GoAwayCode::kTooManyPages;
  return Status::ok();
}

void LiveConversation::tell_shown() {
  for (EditsShown& shown : shown_.take_edits()) tell(std::move(shown));
  for (const double latency_ms : shown_.take_previews()) tell(PreviewShown{latency_ms});
}

namespace {

bool is_link(const LiveEvent& event, LinkState state) {
  const auto* change = std::get_if<LinkChanged>(&event);
  return change != nullptr && change->state == state;
}

// A lost link is told even if it is back already.
bool replaces(const LiveEvent& next, const LiveEvent& last) {
  if (next.index() != last.index()) return false;
  if (is_link(next, LinkState::kLive) && is_link(last, LinkState::kLost)) return false;
  return !std::holds_alternative<EditsAcknowledged>(next) &&
         !std::holds_alternative<EditsRefused>(next) && !std::holds_alternative<EditsShown>(next);
}

}  // namespace

// Keeps the newest of events that replace each other: nobody who does not listen costs memory.
void LiveConversation::tell(LiveEvent event) {
  std::erase_if(news_.events, [&](const LiveEvent& last) { return replaces(event, last); });
  news_.events.push_back(std::move(event));
}

}  // namespace burnish

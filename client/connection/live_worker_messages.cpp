// What SessionLink::Worker does with what the server says.

#include <algorithm>

#include "client/connection/live_worker.h"
#include "common/wire/edit_wire.h"
#include "common/wire/history_wire.h"
#include "common/wire/session_wire.h"
#include "common/wire/status_wire.h"

namespace burnish {

// 0 for a time that is not one of ours.
static double ms_since(uint64_t client_time_us, SessionLink::Worker::Time now) {
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  const auto passed = us.count() - static_cast<int64_t>(client_time_us);
  return client_time_us == 0 || passed < 0 ? 0 : static_cast<double>(passed) / 1000;
}

static std::vector<std::string> ids_of(
    const google::protobuf::RepeatedPtrField<std::string>& edit_ids) {
  return {edit_ids.begin(), edit_ids.end()};
}

Status SessionLink::Worker::hear(const v1::ServerMessage& message, Time now) {
  switch (message.message_case()) {
    case v1::ServerMessage::kWelcome:
      return hear_welcome(message.welcome());
    case v1::ServerMessage::kFrame:
      return hear_frame(message.frame(), now);
    case v1::ServerMessage::kAcknowledged:
      return hear_acknowledged(message.acknowledged());
    case v1::ServerMessage::kRefused:
      return hear_refused(message.refused());
    case v1::ServerMessage::kPeople:
      return hear_people(message.people());
    case v1::ServerMessage::kHistory:
      return hear_history(message.history());
    case v1::ServerMessage::kProgress: {
      const std::lock_guard lock(mutex_);
      tell(ProgressMade{message.progress().phase(), message.progress().fraction()});
      return Status::ok();
    }
    case v1::ServerMessage::kGoAway:
      return hear_farewell(message.go_away());
    case v1::ServerMessage::kHeartbeat:
      hear_heartbeat(message.heartbeat(), now);
      return Status::ok();
    case v1::ServerMessage::MESSAGE_NOT_SET:
      break;  // of a newer server
  }
  return Status::ok();
}

Status SessionLink::Worker::hear_welcome(const v1::Welcome& welcome) {
  RETURN_IF_ERROR(receiver_.welcome(welcome));
  Welcomed welcomed;
  welcomed.connection = welcome.connection();
  welcomed.backend = welcome.backend();
  ASSIGN_OR_RETURN(welcomed.session, from_wire(welcome.session()));
  ASSIGN_OR_RETURN(welcomed.role, from_wire(welcome.role()));
  const std::lock_guard lock(mutex_);
  news_.link = LinkState::kLive;
  tell(LinkChanged{LinkState::kLive, {}});
  tell(std::move(welcomed));
  return Status::ok();
}

Status SessionLink::Worker::hear_frame(const v1::Frame& frame, Time now) {
  ASSIGN_OR_RETURN(auto displacement, receiver_.receive(frame.data()));
  const Time decoded = options_.clock();
  const double server_ms = frame.assemble_ms() + frame.solve_ms() + frame.encode_ms();
  const std::lock_guard lock(mutex_);
  FrameFigures& facts = news_.facts;
  rate_.add(now, frame.data().size());
  ++facts.frames;
  facts.settled = frame.state() == v1::SOLVE_STATE_SETTLED;
  facts.exact = frame.exact();
  facts.cycles = frame.cycles();
  facts.energy = frame.energy();
  facts.residual = frame.residual();
  facts.distance = frame.distance();
  facts.edits = frame.edits();
  facts.assemble_ms = frame.assemble_ms();
  facts.solve_ms = frame.solve_ms();
  facts.encode_ms = frame.encode_ms();
  const double since_heartbeat_ms = ms_since(frame.client_time_us(), decoded);
  facts.age_ms = std::max(0.0, since_heartbeat_ms - pacer_.rtt_ms() / 2);
  facts.bytes += frame.data().size();
  last_decoded_ = decoded;
  has_new_frame_ = true;
  const double link_ms = ms_since(frame.client_time_us(), now) - frame.held_ms();
  pacer_.on_frame(decoded, std::max(0.0, link_ms), server_ms);
  if (link_ms > 0 && pacer_.rtt_ms() > 0)
    budget_.on_frame(frame.data().size(), link_ms - pacer_.rtt_ms());
  facts.credit_window = pacer_.window();
  shown_.frame(frame.edits(), frame.previews(), decoded);
  tell_shown();
  if (!displacement) return Status::ok();
  changed_tiles_.resize(static_cast<size_t>(displacement->layout->tile_count()), true);
  for (const int tile : displacement->changed_tiles)
    changed_tiles_[static_cast<size_t>(tile)] = true;
  news_.displacement = std::move(displacement);
  return Status::ok();
}

Status SessionLink::Worker::hear_acknowledged(const v1::Acknowledged& answer) {
  const std::lock_guard lock(mutex_);
  if (answer.edit_ids().empty()) return Status::ok();
  std::vector<std::string> ids = ids_of(answer.edit_ids());
  const ApplyOutcome outcome = from_wire(answer.outcome());
  if (const auto batch = outbox_.answered(ids.front())) {
    shown_.acknowledged(ids, batch->since, outcome.edits);
    tell_shown();
  }
  tell(AcknowledgedEdits{std::move(ids), outcome});
  acknowledged_.notify_all();
  return Status::ok();
}

Status SessionLink::Worker::hear_refused(const v1::Refused& answer) {
  const StatusCode code = status_code_from_wire(answer.code());
  // It cannot be kept now: the next stream brings it again.
  if (code == StatusCode::kUnavailable) {
    farewell_ = "server " + server_ + ": " + answer.message();
    leaving_ = true;
    return Status::ok();
  }
  const std::lock_guard lock(mutex_);
  std::vector<std::string> ids = ids_of(answer.edit_ids());
  if (ids.empty()) return Status::ok();
  if (!outbox_.answered(ids.front())) outbox_.forget_preview(ids.front());
  tell(RefusedEdits{std::move(ids),
                    {code == StatusCode::kOk ? StatusCode::kInternal : code, answer.message()}});
  acknowledged_.notify_all();
  return Status::ok();
}

Status SessionLink::Worker::hear_people(const v1::People& message) {
  ASSIGN_OR_RETURN(SessionPeople people, from_wire(message));
  const std::lock_guard lock(mutex_);
  tell(PeopleChanged{std::move(people)});
  return Status::ok();
}

Status SessionLink::Worker::hear_history(const v1::HistoryChanged& message) {
  ASSIGN_OR_RETURN(TransferCurve curve, from_wire(message.transfer_curve()));
  const std::lock_guard lock(mutex_);
  tell(HistoryChanged{message.edits(), message.gradient_scale(), std::move(curve)});
  return Status::ok();
}

Status SessionLink::Worker::hear_farewell(const v1::GoAway& message) {
  if (!message.come_back()) return failed_precondition(message.reason());
  farewell_ = "server " + server_ + ": " + message.reason();
  leaving_ = true;
  return Status::ok();
}

void SessionLink::Worker::hear_heartbeat(const v1::Heartbeat& echo, Time now) {
  const double rtt_ms = ms_since(echo.client_time_us(), now);
  if (rtt_ms <= 0) return;
  const std::lock_guard lock(mutex_);
  news_.facts.rtt_ms = rtt_ms;
  pacer_.on_heartbeat(now, rtt_ms);
}

void SessionLink::Worker::tell_shown() {
  for (EditsShown& shown : shown_.take_edits()) tell(std::move(shown));
  for (const double latency_ms : shown_.take_previews()) tell(PreviewShown{latency_ms});
}

// Of what replaces itself the newest is enough, so that nobody who does not listen costs memory.
void SessionLink::Worker::tell(LiveEvent event) {
  const bool replaces =
      std::holds_alternative<PeopleChanged>(event) ||
      std::holds_alternative<HistoryChanged>(event) ||
      std::holds_alternative<ProgressMade>(event) || std::holds_alternative<LinkChanged>(event) ||
      std::holds_alternative<Welcomed>(event) || std::holds_alternative<PreviewShown>(event);
  if (replaces)
    std::erase_if(news_.events,
                  [&](const LiveEvent& other) { return other.index() == event.index(); });
  news_.events.push_back(std::move(event));
}

}  // namespace burnish

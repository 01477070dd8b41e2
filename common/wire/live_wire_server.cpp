// The server's messages in a live session.

#include <algorithm>
#include <iterator>

#include "common/wire/edit_wire.h"
#include "common/wire/history_wire.h"
#include "common/wire/live_wire.h"
#include "common/wire/session_wire.h"
#include "common/wire/status_wire.h"

namespace burnish {
namespace {

void write_stats(const FrameStats& stats, v1::Frame& message) {
  message.set_state(stats.settled ? v1::SOLVE_STATE_SETTLED : v1::SOLVE_STATE_SOLVING);
  write_fields(stats, message);
}

FrameStats read_stats(const v1::Frame& message) {
  FrameStats stats;
  stats.settled = message.state() == v1::SOLVE_STATE_SETTLED;
  read_fields(message, stats);
  return stats;
}

// In the order of GoAwayCode.
constexpr v1::GoAwayCode kGoAwayCodes[] = {
    v1::GO_AWAY_CODE_UNSPECIFIED,   v1::GO_AWAY_CODE_GOING_DOWN, v1::GO_AWAY_CODE_SILENT,
    v1::GO_AWAY_CODE_CLOSED,        v1::GO_AWAY_CODE_REMOVED,    v1::GO_AWAY_CODE_TOO_MANY_PAGES,
    v1::GO_AWAY_CODE_DAMAGED_PAGES, v1::GO_AWAY_CODE_FAILED,     v1::GO_AWAY_CODE_NOT_OWNER};

GoAwayCode read_code(v1::GoAwayCode code) {
  const auto found = std::ranges::find(kGoAwayCodes, code);
  return found == std::end(kGoAwayCodes) ? GoAwayCode::kUnknown
                                         : static_cast<GoAwayCode>(found - kGoAwayCodes);
}

/// Sets the message's member of the oneof.
struct ServerWriter {
  v1::ServerMessage& message;

  void operator()(ProgressReport& report) const {
    message.mutable_progress()->set_phase(std::move(report.phase));
    message.mutable_progress()->set_fraction(report.fraction);
  }
  void operator()(const Welcome& welcome) const {
    v1::Welcome& sent = *message.mutable_welcome();
    *sent.mutable_session() = burnish::to_wire(welcome.session);
    sent.set_role(burnish::to_wire(welcome.role));
    write_fields(welcome, sent);
  }
  void operator()(LiveFrame& frame) const {
    message.mutable_frame()->set_data(std::move(frame.data));
    write_stats(frame.stats, *message.mutable_frame());
  }
  void operator()(EditsAcknowledged& answer) const {
    v1::Acknowledged& sent = *message.mutable_acknowledged();
    for (std::string& id : answer.edit_ids) sent.add_edit_ids(std::move(id));
    *sent.mutable_outcome() = burnish::to_wire(answer.outcome);
  }
  void operator()(EditsRefused& answer) const {
    v1::Refused& sent = *message.mutable_refused();
    for (std::string& id : answer.edit_ids) sent.add_edit_ids(std::move(id));
    sent.set_code(status_code_to_wire(answer.status.code()));
    sent.set_message(answer.status.message());
  }
  void operator()(const HistoryState& history) const {
    v1::HistoryChanged& sent = *message.mutable_history();
    sent.set_edits(history.edits);
    write_settings(history.settings, sent);
  }
  void operator()(const SessionPeople& people) const {
    *message.mutable_people() = burnish::to_wire(people);
  }
  void operator()(const Heartbeat& beat) const {
    message.mutable_heartbeat()->set_client_time_us(beat.client_time_us);
  }
  void operator()(GoAway& go_away) const {
    v1::GoAway& sent = *message.mutable_go_away();
    sent.set_reason(std::move(go_away.reason));
    sent.set_come_back(go_away.come_back);
    sent.set_code(kGoAwayCodes[static_cast<size_t>(go_away.code)]);
    for (std::string& address : go_away.fleet) sent.add_fleet(std::move(address));
    if (!go_away.moved_to) return;
    sent.mutable_moved()->set_address(std::move(go_away.moved_to->address));
    sent.mutable_moved()->set_node(std::move(go_away.moved_to->node));
  }
};

Result<Welcome> read_welcome(const v1::Welcome& message) {
  Welcome welcome;
  ASSIGN_OR_RETURN(welcome.session, from_wire(message.session()));
  ASSIGN_OR_RETURN(welcome.role, from_wire(message.role()));
  read_fields(message, welcome);
  return welcome;
}

template <typename Texts>
std::vector<std::string> to_vector(const Texts& texts) {
  return {texts.begin(), texts.end()};
}

// A code that says OK refuses nothing: something is wrong with the server.
EditsRefused read_refused(const v1::Refused& message) {
  const StatusCode code = status_code_from_wire(message.code());
  return {to_vector(message.edit_ids()),
          {code == StatusCode::kOk ? StatusCode::kInternal : code, message.message()}};
}

Result<HistoryState> read_history(const v1::HistoryChanged& message) {
  ASSIGN_OR_RETURN(Settings settings, read_settings(message));
  return HistoryState{message.edits(), std::move(settings)};
}

GoAway read_go_away(const v1::GoAway& message) {
  GoAway go_away{read_code(message.code()), message.reason(), message.come_back()};
  const ServerPlace place{message.moved().address(), message.moved().node()};
  if (place != ServerPlace()) go_away.moved_to = place;
  go_away.fleet = {message.fleet().begin(), message.fleet().end()};
  return go_away;
}

using AnyServerMessage = std::optional<ServerMessage>;

template <typename Part>
Result<AnyServerMessage> whole_answer(Result<Part> part) {
  if (!part.is_ok()) return part.status();
  return AnyServerMessage(std::move(part).value());
}

}  // namespace

v1::ServerMessage to_wire(ServerMessage message) {
  v1::ServerMessage sent;
  std::visit(ServerWriter{sent}, message);
  return sent;
}

Result<AnyServerMessage> from_wire(v1::ServerMessage message) {
  switch (message.message_case()) {
    case v1::ServerMessage::kProgress:
      return AnyServerMessage(
          ProgressReport{message.progress().phase(), message.progress().fraction()});
    case v1::ServerMessage::kWelcome:
      return whole_answer(read_welcome(message.welcome()));
    case v1::ServerMessage::kFrame:
      return AnyServerMessage(LiveFrame{std::move(*message.mutable_frame()->mutable_data()),
                                        read_stats(message.frame())});
    case v1::ServerMessage::kAcknowledged:
      return AnyServerMessage(EditsAcknowledged{to_vector(message.acknowledged().edit_ids()),
                                                from_wire(message.acknowledged().outcome())});
    case v1::ServerMessage::kRefused:
      return AnyServerMessage(read_refused(message.refused()));
    case v1::ServerMessage::kHistory:
      return whole_answer(read_history(message.history()));
    case v1::ServerMessage::kPeople:
      return whole_answer(from_wire(message.people()));
    case v1::ServerMessage::kHeartbeat:
      return AnyServerMessage(Heartbeat{message.heartbeat().client_time_us()});
    case v1::ServerMessage::kGoAway:
      return AnyServerMessage(read_go_away(message.go_away()));
    case v1::ServerMessage::MESSAGE_NOT_SET:
      break;
  }
  return AnyServerMessage();
}

}  // namespace burnish

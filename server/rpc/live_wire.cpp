#include "server/rpc/live_wire.h"

#include "common/wire/edit_wire.h"
#include "common/wire/history_wire.h"
#include "common/wire/session_wire.h"
#include "common/wire/status_wire.h"

namespace burnish {

Result<std::vector<Edit>> edits_from_wire(
    const google::protobuf::RepeatedPtrField<v1::Edit>& messages) {
  const auto count = static_cast<size_t>(messages.size());
  if (count == 0 || count > kEditsPerFrameMax)
    return invalid_argument("a request has 1 to " + std::to_string(kEditsPerFrameMax) +
                            " edits, not " + std::to_string(count));
  std::vector<Edit> edits;
  for (const v1::Edit& message : messages) {
    ASSIGN_OR_RETURN(Edit edit, from_wire(message));
    edits.push_back(std::move(edit));
  }
  return edits;
}

Result<LiveGreeting> from_wire(const v1::Greeting& message) {
  LiveGreeting greeting{message.session(), message.triangles_max(), {}};
  switch (message.content()) {
    case v1::FRAME_CONTENT_UNSPECIFIED:
      return greeting;
    case v1::FRAME_CONTENT_COEFFICIENTS:
      greeting.content = FrameContent::kCoefficients;
      return greeting;
    case v1::FRAME_CONTENT_VERTICES:
      greeting.content = FrameContent::kVertices;
      return greeting;
    default:
      break;
  }
  return invalid_argument("frame content " + std::to_string(message.content()) +
                          " is none of 0 (whichever is smaller), 1 (coefficients), 2 (vertices)");
}

Result<FrameCredit> from_wire(const v1::Credit& message) {
  static constexpr int kSequencesMax = 256;
  if (message.decoded_size() > kSequencesMax || message.refused_size() > kSequencesMax)
    return invalid_argument("a credit names " + std::to_string(message.decoded_size()) +
                            " decoded and " + std::to_string(message.refused_size()) +
                            " refused frames, the limit is " + std::to_string(kSequencesMax));
  return FrameCredit{message.frames(),
                     {message.decoded().begin(), message.decoded().end()},
                     {message.refused().begin(), message.refused().end()},
                     message.key_frame(),
                     message.frame_bytes()};
}

Result<PreviewPiece> from_wire(const v1::Preview& message) {
  v1::Edit whole;
  whole.set_id(message.edit_id());
  if (message.has_gradient_scale()) *whole.mutable_gradient_scale() = message.gradient_scale();
  if (message.has_transfer_curve()) *whole.mutable_transfer_curve() = message.transfer_curve();
  if (message.has_stroke()) *whole.mutable_stroke() = message.stroke();
  ASSIGN_OR_RETURN(Edit edit, from_wire(whole));
  PreviewPiece piece{std::move(edit.id), {}};
  if (auto* slider = std::get_if<SetGradientScale>(&edit.change)) piece.change = *slider;
  if (auto* curve = std::get_if<SetTransferCurve>(&edit.change)) piece.change = std::move(*curve);
  if (auto* stroke = std::get_if<Stroke>(&edit.change)) piece.change = std::move(*stroke);
  return piece;
}

Result<std::optional<BrushRing>> from_wire(const v1::MoveBrush& message) {
  if (!message.has_ring()) return std::optional<BrushRing>();
  ASSIGN_OR_RETURN(const BrushRing ring, from_wire(message.ring()));
  return std::optional(ring);
}

v1::ServerMessage to_wire(const LiveClient& client) {
  v1::ServerMessage message;
  v1::Welcome& welcome = *message.mutable_welcome();
  const FrameLayout& layout = *client.subscriber->target->layout;
  *welcome.mutable_session() = to_wire(client.info);
  welcome.set_connection(client.subscriber->connection);
  welcome.set_role(to_wire(client.role));
  welcome.set_content(layout.content == FrameContent::kVertices ? v1::FRAME_CONTENT_VERTICES
                                                                : v1::FRAME_CONTENT_COEFFICIENTS);
  welcome.set_layout_fingerprint(layout.fingerprint);
  welcome.set_backend(client.backend);
  return message;
}

namespace {

/// Sets the message's member of the oneof.
struct MessageWriter {
  v1::ServerMessage& message;

  void operator()(LiveFrame& frame) const {
    v1::Frame& sent = *message.mutable_frame();
    const FrameFacts& facts = frame.facts;
    sent.set_data(std::move(frame.data));
    sent.set_state(facts.settled ? v1::SOLVE_STATE_SETTLED : v1::SOLVE_STATE_SOLVING);
    sent.set_exact(facts.exact);
    sent.set_cycles(facts.report.cycle);
    sent.set_energy(facts.report.energy);
    sent.set_residual(facts.report.residual);
    sent.set_distance(facts.report.distance);
    sent.set_edits(facts.edits);
    sent.set_assemble_ms(facts.assemble_ms);
    sent.set_solve_ms(facts.solve_ms);
    sent.set_encode_ms(facts.encode_ms);
    sent.set_client_time_us(facts.client_time_us);
    sent.set_previews(facts.previews);
    sent.set_held_ms(facts.held_ms);
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
  void operator()(const SessionPeople& people) const {
    *message.mutable_people() = burnish::to_wire(people);
  }
  void operator()(const HistoryState& history) const {
    v1::HistoryChanged& sent = *message.mutable_history();
    sent.set_edits(history.edits);
    sent.set_gradient_scale(history.gradient_scale);
    *sent.mutable_transfer_curve() = burnish::to_wire(history.transfer_curve);
  }
  void operator()(const HeartbeatEcho& echo) const {
    message.mutable_heartbeat()->set_client_time_us(echo.client_time_us);
  }
  void operator()(Farewell& farewell) const {
    message.mutable_go_away()->set_reason(std::move(farewell.reason));
    message.mutable_go_away()->set_come_back(farewell.come_back);
  }
};

}  // namespace

v1::ServerMessage to_wire(LiveMessage live) {
  v1::ServerMessage message;
  std::visit(MessageWriter{message}, live);
  return message;
}

}  // namespace burnish

#include "server/rpc/edit_call.h"

#include "common/service/scan_info.h"
#include "server/rpc/live_wire.h"
#include "server/rpc/message_bytes.h"

namespace burnish {

EditCall::EditCall(const CallContext& calls, grpc::CallbackServerContext& context)
    : calls_(calls),
      context_(context),
      writer_([this](const v1::ServerMessage* message) { write(*message); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void EditCall::OnReadDone(bool ok) {
  run_guarded([&] { take_message(ok); }, [this](const Status& why) { writer_.end(why); });
}

void EditCall::take_message(bool ok) {
  if (!ok) return end_of_requests();
  const Status stays = calls_.may_stay ? calls_.may_stay() : Status::ok();
  if (!stays.is_ok()) return writer_.end(stays);
  const Status parsed = parse(received_, request_);
  if (!parsed.is_ok()) return writer_.end(parsed);
  if (!client_) return take_greeting();
  client_->subscriber->heard();
  const Status status = take_request();
  if (!status.is_ok()) return refuse(status);
  reading_paused_ = true;
  read_on();
}

void EditCall::write(const v1::ServerMessage& message) {
  serialize(message, sent_);
  StartWrite(&sent_);
}

void EditCall::refuse(const Status& status) {
  writer_.end(malformed(status));
}

void EditCall::end_of_requests() {
  if (cancelled_) return writer_.end(cancelled("the client has gone"));
  if (!client_) return refuse(invalid_argument("a live session must begin with a greeting"));
  client_->subscriber->close(std::nullopt);
}

void EditCall::take_greeting() {
  if (!request_.has_greeting())
    return refuse(invalid_argument("a live session must begin with a greeting"));
  const auto join = [call = self()] {
    const auto client = call->join();
    if (client.is_ok()) return call->take_place(client.value());
    call->writer_.end(client.status());
  };
  calls_.executor.post(join, [call = self()](const Status& why) { call->writer_.end(why); });
}

Result<LiveClient> EditCall::join() {
  RETURN_IF_ERROR(check_references(request_));
  ASSIGN_OR_RETURN(const LiveGreeting greeting, from_wire(request_.greeting()));
  const Progress progress = [this](std::string_view phase, double fraction) {
    writer_.report_progress(phase, fraction);
    return !cancelled_;
  };
  SubscriberWiring wiring;
  wiring.on_message = [weak = std::weak_ptr(self())] {
    const auto call = weak.lock();
    if (!call) return;
    call->writer_.pump();
    call->read_on();
  };
  wiring.on_dead = [weak = std::weak_ptr(self())] {
    if (const auto call = weak.lock()) call->cut();
  };
  wiring.may_stay = calls_.may_stay;
  return calls_.live.join(greeting, calls_.caller, std::move(wiring), progress);
}

void EditCall::take_place(const LiveClient& client) {
  {
    const std::lock_guard lock(mutex_);
    if (done_) return calls_.live.leave(client);
    client_ = client;
  }
  writer_.begin(client);
  writer_.unless_finished([this] { StartRead(&received_); });
}

Status EditCall::take_request() {
  LiveSession& session = *client_->session;
  Subscriber& subscriber = *client_->subscriber;
  switch (request_.message_case()) {
    case v1::ClientMessage::kCredit: {
      ASSIGN_OR_RETURN(const FrameCredit credit, from_wire(request_.credit()));
      subscriber.grant(credit);
      return Status::ok();
    }
    case v1::ClientMessage::kApply:
      take_edits(request_.apply());
      return Status::ok();
    case v1::ClientMessage::kPreview:
      take_preview(request_.preview());
      return Status::ok();
    case v1::ClientMessage::kMoveBrush: {
      ASSIGN_OR_RETURN(const auto ring, from_wire(request_.move_brush()));
      session.move_brush(subscriber.connection, ring);
      return Status::ok();
    }
    case v1::ClientMessage::kHeartbeat:
      subscriber.beat(request_.heartbeat().client_time_us());
      return Status::ok();
    case v1::ClientMessage::kGreeting:
      return invalid_argument("a live session must have only one greeting");
    case v1::ClientMessage::MESSAGE_NOT_SET:
      break;
  }
  return invalid_argument("this server does not know the message's kind");
}

void EditCall::take_edits(const v1::ApplyEdits& message) {
  auto edits = edits_from_wire(message.edits());
  if (edits.is_ok())
    return client_->session->edit(client_->subscriber->connection, std::move(edits).value(),
                                  message.ByteSizeLong());
  EditsRefused refused{{}, edits.status()};
  for (const v1::Edit& edit : message.edits())
    if (refused.edit_ids.size() < kEditsPerFrameMax && edit.id().size() <= kEditIdBytesMax)
      refused.edit_ids.push_back(edit.id());
  client_->subscriber->refuse_unexpected(std::move(refused));
}

void EditCall::take_preview(const v1::Preview& message) {
  const uint64_t connection = client_->subscriber->connection;
  if (message.has_drop()) return client_->session->drop_preview(connection, message.edit_id());
  auto piece = from_wire(message);
  const Status status = piece.is_ok()
                            ? client_->session->preview(connection, std::move(piece).value())
                            : piece.status();
  if (status.is_ok()) return;
  EditsRefused refused{{}, status};
  if (message.edit_id().size() <= kEditIdBytesMax) refused.edit_ids.push_back(message.edit_id());
  client_->subscriber->refuse_unexpected(std::move(refused));
}

// Whoever does not take its answers, or sends edits faster than they are done, is not read.
void EditCall::read_on() {
  if (!reading_paused_ || !client_->subscriber->may_send() || !reading_paused_.exchange(false))
    return;
  writer_.unless_finished([this] { StartRead(&received_); });
}

void EditCall::OnWriteDone(bool ok) {
  writer_.on_write_done(ok);
  read_on();
}

void EditCall::OnCancel() {
  cancelled_ = true;
  writer_.end(cancelled("the client has gone"));
}

void EditCall::cut() {
  const std::lock_guard lock(mutex_);
  if (!done_) context_.TryCancel();
}

void EditCall::OnDone() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
    if (client_) calls_.live.leave(*client_);
  }
  release();
}

}  // namespace burnish

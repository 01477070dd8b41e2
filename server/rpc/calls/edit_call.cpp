#include "server/rpc/calls/edit_call.h"

#include "common/wire/live_wire.h"
#include "server/rpc/transport/message_bytes.h"

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
    if (client.is_ok()) return call->take_slot(client.value());
    call->writer_.end(client.status());
  };
  calls_.executor.post(join, [call = self()](const Status& why) { call->writer_.end(why); });
}

Result<LiveClient> EditCall::join() {
  RETURN_IF_ERROR(check_references(request_));
  ASSIGN_OR_RETURN(const Greeting greeting, from_wire(request_.greeting()));
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

void EditCall::take_slot(const LiveClient& client) {
  {
    const std::lock_guard lock(mutex_);
    if (done_) return calls_.live.leave(client);
    client_ = client;
  }
  writer_.begin(client);
  writer_.unless_finished([this] { StartRead(&received_); });
}

// Refuses a wrong edit or preview. Any other wrong message ends the call.
Status EditCall::take_request() {
  auto message = from_wire(request_);
  const Status status = message.is_ok()
                            ? std::visit([this](auto& said) { return take(said); }, *message)
                            : message.status();
  const bool is_refusable = request_.has_apply() || request_.has_preview();
  if (status.is_ok() || !is_refusable) return status;
  client_->subscriber->refuse_unexpected({refused_ids(request_), status});
  return Status::ok();
}

Status EditCall::take(const Greeting&) {
  return invalid_argument("a live session must have only one greeting");
}

Status EditCall::take(const FrameCredit& credit) {
  client_->subscriber->grant(credit);
  return Status::ok();
}

Status EditCall::take(ApplyEdits& apply) {
  client_->session->edit(connection(), std::move(apply.edits), request_.apply().ByteSizeLong());
  return Status::ok();
}

Status EditCall::take(Preview& piece) {
  return client_->session->preview(connection(), std::move(piece));
}

Status EditCall::take(const DropPreview& drop) {
  client_->session->drop_preview(connection(), drop.edit_id);
  return Status::ok();
}

Status EditCall::take(const MoveBrush& move) {
  client_->session->move_brush(connection(), move.ring);
  return Status::ok();
}

Status EditCall::take(const Heartbeat& beat) {
  client_->subscriber->beat(beat.client_time_us);
  return Status::ok();
}

Status EditCall::take(const ShowPages& change) {
  return client_->subscriber->show_pages(change);
}

// Does not read a client that does not take its answers, or sends edits faster than they are done.
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

#include "server/rpc/calls/import_call.h"

#include <spdlog/spdlog.h>

#include "common/wire/library_wire.h"
#include "server/rpc/transport/message_bytes.h"

namespace burnish {

static v1::ImportEvent received_event(uint64_t bytes) {
  v1::ImportEvent event;
  event.mutable_received()->set_bytes(bytes);
  return event;
}

ImportCall::ImportCall(const CallContext& calls)
    : calls_(calls),
      silence_(calls.upload_silence_max),
      events_([this](const v1::ImportEvent* event) { write(*event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void ImportCall::begin() {
  silence_.start(self(), [this](const Status& status) { end(status); });
  read_next();
}

void ImportCall::read_next() {
  silence_.wait();
  StartRead(&received_);
}

void ImportCall::OnReadDone(bool ok) {
  if (!silence_.heard()) return;
  if (!ok) return end_of_requests();
  const auto take = [call = self()] {
    const Status status = call->take_request();
    if (!status.is_ok()) call->end(status);
  };
  calls_.executor.post(take, failing(), received_.Length());
}

std::function<void(const Status&)> ImportCall::failing() {
  return [call = self()](const Status& status) { call->end(status); };
}

void ImportCall::write(const v1::ImportEvent& event) {
  serialize(event, sent_);
  StartWrite(&sent_);
}

Status ImportCall::take_request() {
  RETURN_IF_ERROR(parse(received_, request_));
  if (request_.has_header()) return take_header(request_.header());
  if (request_.has_chunk()) return take_chunk(request_.chunk());
  return malformed(invalid_argument("a message of an import must be a header or a chunk"));
}

Status ImportCall::take_header(const v1::ImportHeader& message) {
  if (upload_) return malformed(invalid_argument("an import must have only one header"));
  ASSIGN_OR_RETURN(header_, from_wire(message));
  ASSIGN_OR_RETURN(upload_, calls_.store.begin_upload(header_, calls_.user));
  if (header_.sha256.empty()) {
    ask_for_chunks();
  } else {
    calls_.executor.post(
        Pool::kLong, [call = self()] { call->look_for_known(); }, failing());
  }
  return Status::ok();
}

void ImportCall::look_for_known() {
  const auto known =
      calls_.store.import_known(header_.sha256, header_.key, progress(), calls_.user);
  if (known.is_ok() || known.status().code() != StatusCode::kNotFound) return end(known);
  const Status name = calls_.store.check_new_name(header_);
  if (!name.is_ok()) return end(name);
  ask_for_chunks();
}

void ImportCall::ask_for_chunks() {
  events_.push(received_event(0));
  read_next();
}

Status ImportCall::take_chunk(const v1::Chunk& chunk) {
  if (!upload_) return malformed(invalid_argument("an import must begin with its header"));
  RETURN_IF_ERROR(upload_->append(chunk.offset(), chunk.data(), chunk.crc32()));
  events_.offer(received_event(upload_->received_bytes()));
  read_next();
  return Status::ok();
}

void ImportCall::end_of_requests() {
  if (cancelled_) return end(cancelled("the client has gone"));
  if (!upload_) return end(invalid_argument("an import must begin with its header"));
  const Status stays = calls_.may_stay ? calls_.may_stay() : Status::ok();
  if (!stays.is_ok()) return end(stays);
  const auto import = [call = self()] {
    call->end(call->calls_.store.import(
        *call->upload_, call->header_, give_way_to(call->calls_.live.scheduler(), call->progress()),
        call->calls_.user));
  };
  calls_.executor.post(Pool::kLong, import, failing());
}

void ImportCall::end(const Result<ImportOutcome>& outcome) {
  if (outcome.is_ok()) {
    v1::ImportEvent event;
    *event.mutable_done()->mutable_scan() = to_wire(outcome.value().scan);
    event.mutable_done()->set_already_present(outcome.value().already_present);
    events_.push(std::move(event));
    spdlog::info("import {}: scan {}", header_.name, short_id(outcome.value().scan.id));
  }
  events_.close(to_grpc(outcome.status()));
}

Progress ImportCall::progress() {
  return [this](std::string_view phase, double fraction) {
    events_.report(phase, fraction);
    return !cancelled_;
  };
}

}  // namespace burnish

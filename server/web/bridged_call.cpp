#include "server/web/bridged_call.h"

#include "server/web/gateway_mark.h"

namespace burnish {

BridgedCall::BridgedCall(const WebCalls& calls, const std::string& method, const Caller& caller,
                         Events events)
    : calls_(calls), method_(method), events_(std::move(events)), stub_(calls.channel) {
  context_.AddMetadata(kGatewaySecretKey, calls_.secret);
  context_.AddMetadata(kGatewayPeerKey, caller.peer);
  if (!caller.certificate.empty()) context_.AddMetadata(kGatewayCertificateKey, caller.certificate);
  if (!caller.authorization.empty()) context_.AddMetadata("authorization", caller.authorization);
  if (caller.user) context_.AddMetadata("burnish-user-bin", *caller.user);
}

void BridgedCall::start() {
  self_ = shared_from_this();
  stub_.PrepareBidiStreamingCall(&context_, method_, {}, this);
  AddHold();
  StartCall();
  read_next();
}

bool BridgedCall::send(const grpc::ByteBuffer& bytes) {
  if (!is_held_) return false;
  out_ = bytes;
  StartWrite(&out_);
  return true;
}

void BridgedCall::end_messages() {
  if (is_held_) StartWritesDone();
}

void BridgedCall::read_next() {
  if (!is_held_) return;
  is_reading_ = true;
  StartRead(&in_);
}

void BridgedCall::cancel() {
  is_cancelled_ = true;
  context_.TryCancel();
  if (!is_reading_) let_go();
}

void BridgedCall::OnReadDone(bool ok) {
  events_.post([this, ok] { read_done(ok); });
}

void BridgedCall::OnWriteDone(bool /*ok*/) {
  events_.post([this] {
    out_.Clear();
    events_.on_sent();
  });
}

void BridgedCall::OnDone(const grpc::Status& status) {
  // gRPC 1.51 keeps an ended call inside the process, 27 kB, until the server's end, if the status
  // came before the client's half-close. A cancel after the end frees it and changes nothing else.
  context_.TryCancel();
  events_.post([this, status] {
    const auto held = std::move(self_);
    const Events events = std::move(events_);
    events.on_end(status);
  });
}

void BridgedCall::read_done(bool ok) {
  is_reading_ = false;
  if (!ok || is_cancelled_) return let_go();
  grpc::ByteBuffer message;
  message.Swap(&in_);
  events_.on_message(std::move(message));
}

void BridgedCall::let_go() {
  if (std::exchange(is_held_, false)) RemoveHold();
}

}  // namespace burnish

#include "tests/system/live_stream.h"

#include <cstring>

#include "tests/system/server_process.h"

namespace burnish {

LiveStream::LiveStream(const std::shared_ptr<grpc::Channel>& channel, const std::string& user)
    : stub_(v1::Editing::NewStub(channel)) {
  context_.set_deadline(std::chrono::system_clock::now() + kPatience);
  if (!user.empty()) context_.AddMetadata("burnish-user-bin", user);
  stream_ = stub_->Edit(&context_);
}

LiveStream::~LiveStream() {
  if (ended_) return;
  context_.TryCancel();
  (void)end();
}

void LiveStream::greet(const std::string& session) {
  v1::ClientMessage message;
  message.mutable_greeting()->set_session(session);
  message.mutable_greeting()->set_pages(true);
  send(message);
  message.mutable_show_pages()->set_revision(1);
  message.mutable_show_pages()->add_added(0);
  send(message);
}

void LiveStream::credit(uint32_t frames, const std::vector<uint64_t>& decoded) {
  v1::ClientMessage message;
  message.mutable_credit()->set_frames(frames);
  for (const uint64_t sequence : decoded) message.mutable_credit()->add_decoded(sequence);
  send(message);
}

void LiveStream::slide(const std::string& id, double beta) {
  v1::ClientMessage message;
  v1::Edit* edit = message.mutable_apply()->add_edits();
  edit->set_id(id);
  edit->mutable_gradient_scale()->set_beta(beta);
  send(message);
}

void LiveStream::preview_slide(const std::string& id, double beta) {
  v1::ClientMessage message;
  message.mutable_preview()->set_edit_id(id);
  message.mutable_preview()->mutable_gradient_scale()->set_beta(beta);
  send(message);
}

void LiveStream::beat(uint64_t time_us) {
  v1::ClientMessage message;
  message.mutable_heartbeat()->set_client_time_us(time_us);
  send(message);
}

v1::ServerMessage LiveStream::next(const std::function<bool(const v1::ServerMessage&)>& is_wanted) {
  v1::ServerMessage message;
  while (stream_->Read(&message)) {
    if (is_wanted(message)) return message;
    seen.push_back(message);
  }
  return {};
}

v1::ServerMessage LiveStream::next(v1::ServerMessage::MessageCase wanted) {
  return next([&](const v1::ServerMessage& message) { return message.message_case() == wanted; });
}

v1::Frame LiveStream::settle() {
  for (;;) {
    const v1::ServerMessage message = next(v1::ServerMessage::kFrame);
    if (!message.has_frame() || message.frame().state() == v1::SOLVE_STATE_SETTLED)
      return message.frame();
    credit(1, {sequence_of(message.frame())});
  }
}

grpc::Status LiveStream::end() {
  ended_ = true;
  (void)next(v1::ServerMessage::MESSAGE_NOT_SET);
  return stream_->Finish();
}

uint64_t sequence_of(const v1::Frame& frame) {
  uint64_t sequence = 0;  // little-endian, as this machine
  if (frame.data().size() >= 16) std::memcpy(&sequence, frame.data().data() + 8, sizeof(sequence));
  return sequence;
}

}  // namespace burnish

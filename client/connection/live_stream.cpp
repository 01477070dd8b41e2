#include "client/connection/live_stream.h"

#include <future>

#include "client/connection/connection_state.h"
#include "common/wire/live_wire.h"

namespace burnish {

// Operations start on the thread that owns the stream, not in reactions: a hold keeps gRPC from
// ending the call between two of them.

// Keeps gRPC's threads for callbacks, once they are there, as long as the process lives. gRPC 1.51
// ends them with the last channel that needs them, and aborts when that happens on one of them: a
// stream that outlives its channel's other owners ends exactly there. So a channel that leads
// nowhere is never destroyed; its one call fails at once.
static void keep_callback_threads() {
  [[gnu::used]] static const auto* kept = [] {
    auto* channel = new std::shared_ptr<grpc::Channel>(grpc::CreateChannel("", nullptr));
    grpc::ClientContext context;
    const v1::GetStateRequest request;
    v1::SessionState response;
    std::promise<void> done;
    v1::Editing::Stub(*channel).async()->GetState(
        &context, &request, &response, [&done](const grpc::Status&) { done.set_value(); });
    done.get_future().wait();
    return channel;
  }();
}

LiveStream::LiveStream(std::shared_ptr<grpc::Channel> channel, std::shared_ptr<Wakeup> wakeup)
    : channel_(std::move(channel)),
      stub_(v1::Editing::NewStub(channel_)),
      wakeup_(std::move(wakeup)) {}

std::shared_ptr<LiveStream> LiveStream::start(std::shared_ptr<grpc::Channel> channel,
                                              const LiveHeaders& headers,
                                              std::shared_ptr<Wakeup> wakeup) {
  keep_callback_threads();
  const std::shared_ptr<LiveStream> stream(new LiveStream(std::move(channel), std::move(wakeup)));
  stream->self_ = stream;
  if (!headers.user.empty()) stream->context_.AddMetadata("burnish-user-bin", headers.user);
  set_node(stream->context_, headers.node);
  stream->stub_->async()->Edit(&stream->context_, stream.get());
  stream->AddHold();
  stream->StartRead(&stream->incoming_);
  stream->StartCall();
  return stream;
}

bool LiveStream::can_write() const {
  const std::lock_guard lock(mutex_);
  return !writing_ && !closed_;
}

void LiveStream::write(const ClientMessage& message) {
  const std::lock_guard lock(mutex_);
  if (writing_ || closed_) return;
  writing_ = true;
  outgoing_ = to_wire(message);
  StartWrite(&outgoing_);
}

std::optional<v1::ServerMessage> LiveStream::take_message() {
  const std::lock_guard lock(mutex_);
  if (!has_message_) return std::nullopt;
  has_message_ = false;
  v1::ServerMessage message = std::move(incoming_);
  if (cancelled_) {
    close();
  } else {
    StartRead(&incoming_);
  }
  return message;
}

std::optional<grpc::Status> LiveStream::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void LiveStream::cancel() {
  context_.TryCancel();
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  if (has_message_) close();  // no read is under way that could fail
}

void LiveStream::OnReadDone(bool ok) {
  {
    const std::lock_guard lock(mutex_);
    has_message_ = ok;
    if (!ok || cancelled_) close();
  }
  wakeup_->wake();
}

void LiveStream::OnWriteDone(bool ok) {
  {
    const std::lock_guard lock(mutex_);
    writing_ = !ok;  // after a failure nothing more can be written
  }
  wakeup_->wake();
}

void LiveStream::close() {
  if (closed_) return;
  closed_ = true;
  RemoveHold();
}

void LiveStream::OnDone(const grpc::Status& status) {
  const std::shared_ptr<LiveStream> last = std::move(self_);
  {
    const std::lock_guard lock(mutex_);
    status_ = status;
  }
  wakeup_->wake();
}

}  // namespace burnish

#include "server/rpc/calls/watch_call.h"

#include <chrono>

#include "common/wire/live_wire.h"

namespace burnish {

static constexpr std::chrono::milliseconds kFrameInterval{100};

WatchCall::WatchCall(const CallContext& calls, grpc::CallbackServerContext& context,
                     const v1::WatchRequest& request)
    : calls_(calls),
      context_(context),
      request_(request),
      writer_([this](const v1::ServerMessage* message) { StartWrite(message); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void WatchCall::begin() {
  const auto join = [call = self()] {
    const auto client = call->join();
    if (client.is_ok()) return call->take_slot(client.value());
    call->writer_.end(client.status());
  };
  calls_.executor.post(join, [call = self()](const Status& why) { call->writer_.end(why); });
}

Result<LiveClient> WatchCall::join() {
  ASSIGN_OR_RETURN(const Greeting greeting, from_wire(request_.greeting()));
  const Progress progress = [this](std::string_view phase, double fraction) {
    writer_.report_progress(phase, fraction);
    return !cancelled_;
  };
  SubscriberWiring wiring;
  wiring.may_be_silent = true;
  wiring.on_message = [weak = std::weak_ptr(self())] {
    if (const auto call = weak.lock()) call->writer_.pump();
  };
  wiring.on_dead = [weak = std::weak_ptr(self())] {
    if (const auto call = weak.lock()) call->cut();
  };
  wiring.may_stay = calls_.may_stay;
  ASSIGN_OR_RETURN(const LiveClient client,
                   calls_.live.join(greeting, calls_.caller, std::move(wiring), progress));
  const Status shown = show_pages(client);
  if (shown.is_ok()) return client;
  calls_.live.leave(client);
  return shown;
}

// The client cannot show other pages later.
Status WatchCall::show_pages(const LiveClient& client) const {
  if (request_.pages().empty()) return Status::ok();
  return client.subscriber->show_pages({1, {request_.pages().begin(), request_.pages().end()}, {}});
}

// The client never says which frames it holds, so every frame is a key frame. No frame is made of a
// surface that was sent already.
static void grant_frame(const LiveClient& client) {
  client.subscriber->grant({.frames = 1});
}

void WatchCall::take_slot(const LiveClient& client) {
  {
    const std::lock_guard lock(mutex_);
    if (done_) return calls_.live.leave(client);
    client_ = client;
  }
  writer_.begin(client);
  grant_frame(client);
}

void WatchCall::OnWriteDone(bool ok) {
  const bool was_frame = writer_.written().has_frame();
  writer_.on_write_done(ok);
  if (ok && was_frame) grant_later();
}

void WatchCall::grant_later() {
  const std::lock_guard lock(mutex_);
  if (done_) return;
  // Weak: an alarm keeps its function even after it has rung, and the call owns the alarm.
  next_frame_.Set(std::chrono::system_clock::now() + kFrameInterval,
                  [weak = std::weak_ptr(self())](bool is_time) {
                    const auto call = weak.lock();
                    if (is_time && call) grant_frame(*call->client_);
                  });
}

void WatchCall::OnCancel() {
  cancelled_ = true;
  writer_.end(cancelled("the client has gone"));
}

void WatchCall::cut() {
  const std::lock_guard lock(mutex_);
  if (!done_) context_.TryCancel();
}

void WatchCall::OnDone() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
    next_frame_.Cancel();
    if (client_) calls_.live.leave(*client_);
  }
  release();
}

}  // namespace burnish

#include "client/connection/live_worker.h"

#include "client/connection/channel.h"
#include "client/connection/connection_state.h"
#include "common/wire/live_wire.h"

namespace burnish {

SessionLink::Worker::Worker(const std::shared_ptr<ServerRoute>& route, const ConnectionTrust& trust,
                            const std::string& user, Connection::Starter starter,
                            LiveOptions options)
    : route_(route),
      trust_(trust),
      user_(user),
      starter_(std::move(starter)),
      clock_(options.clock),
      on_news_(options.on_news),
      conversation_(route, std::move(options)) {
  thread_ = std::thread([this] { run(); });
}

SessionLink::Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake();
  thread_.join();
}

bool SessionLink::Worker::wait_until_acknowledged(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  heard_.wait_for(lock, patience, [this] {
    return conversation_.unacknowledged() == 0 || conversation_.has_ended();
  });
  return conversation_.unacknowledged() == 0;
}

void SessionLink::Worker::run() {
  for (;;) {
    const Status why = converse();
    if (is_stopping()) return;
    const auto wait = conversation_.end(why);
    tell_user();
    if (!wait) return;
    wait_before_retry(*wait);
  }
}

// Whatever keeps it from starting may be over at the next try: edits wait for that.
Status SessionLink::Worker::start_server() {
  if (!starter_) return Status::ok();
  const Status started = starter_([this](std::string_view, double) { return !is_stopping(); });
  return started.is_ok() ? started : unavailable(started.message());
}

// Returns how the stream ended, or why it did not begin.
Status SessionLink::Worker::converse() {
  RETURN_IF_ERROR(start_server());
  // A channel of its own for each try: no back-off but ours, and certificates as they are now.
  const ServerPlace server = route_->place();
  ASSIGN_OR_RETURN(auto channel, make_channel(server.address, trust_, Sharing::kOwn));
  if (is_stopping()) return cancelled("the session was left");
  conversation_.begin();
  const auto stream = LiveStream::start(std::move(channel), {user_, server.node}, wakeup_);
  speak_and_listen(*stream);
  stream->cancel();
  while (!stream->status()) {
    stream->take_message();
    wakeup_->wait_for(std::chrono::seconds(1));
  }
  return call_status(server.address, *stream->status());
}

// Until the stream has ended, or has to.
void SessionLink::Worker::speak_and_listen(LiveStream& stream) {
  while (!stream.status() && !is_stopping() && !conversation_.must_leave()) {
    if (auto message = stream.take_message()) {
      if (conversation_.hear(from_wire(std::move(*message)))) tell_user();
      continue;
    }
    if (stream.can_write()) {
      if (const auto message = conversation_.next()) {
        stream.write(*message);
        continue;
      }
    }
    wakeup_->wait_for(conversation_.next_deadline() - clock_());
  }
}

void SessionLink::Worker::wait_before_retry(std::chrono::milliseconds time) {
  const auto until = clock_() + time;
  while (clock_() < until && !is_stopping()) wakeup_->wait_for(until - clock_());
}

bool SessionLink::Worker::is_stopping() {
  const std::lock_guard lock(mutex_);
  return stopping_;
}

void SessionLink::Worker::tell_user() {
  {
    const std::lock_guard lock(mutex_);  // whoever waits sees the change or is woken
  }
  heard_.notify_all();
  if (on_news_) on_news_();
}

}  // namespace burnish

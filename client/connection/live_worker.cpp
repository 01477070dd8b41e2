#include "client/connection/live_worker.h"

#include <algorithm>
#include <random>

#include "client/connection/channel.h"
#include "client/connection/connection_state.h"

namespace burnish {

// What another try may cure. The rest is about what was asked for, or who asked.
static bool is_worth_another_try(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
    case StatusCode::kUnavailable:
    case StatusCode::kCancelled:
    case StatusCode::kDeadlineExceeded:
    case StatusCode::kResourceExhausted:
    case StatusCode::kInternal:
      return true;
    default:
      return false;
  }
}

SessionLink::Worker::Worker(const std::string& server, const ConnectionTrust& trust,
                            const std::string& user, Connection::Starter starter,
                            LiveOptions options)
    : server_(server),
      trust_(trust),
      user_(user),
      starter_(std::move(starter)),
      options_(std::move(options)),
      receiver_({options_.head, options_.depth, options_.pages_fingerprint}),
      outbox_(options_.greeting, options_.head.page_count()),
      pacer_(options_.draw_interval) {
  thread_ = std::thread([this] { run(); });
}

SessionLink::Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wakeup_->wake();
  thread_.join();
}

void SessionLink::Worker::run() {
  for (int failures = 0;; ++failures) {
    const uint64_t frames_before = news_.stats.frames;
    const Status why = converse();
    {
      const std::lock_guard lock(mutex_);
      if (stopping_) return;
      const bool was_live = news_.link == LinkState::kLive;
      news_.pages_refused += was_live && why.code() == StatusCode::kResourceExhausted;
    }
    if (!is_worth_another_try(why.code())) return set_link(LinkState::kEnded, why.to_string());
    set_link(news_.link == LinkState::kConnecting ? LinkState::kConnecting : LinkState::kLost,
             why.message());
    if (news_.stats.frames > frames_before) failures = 0;
    wait_before_retry(failures);
  }
}

// Whatever keeps it from starting may be over at the next try: edits wait for that.
Status SessionLink::Worker::start_server() {
  if (!starter_) return Status::ok();
  const Status started = starter_([this](std::string_view, double) {
    const std::lock_guard lock(mutex_);
    return !stopping_;
  });
  return started.is_ok() ? started : unavailable(started.message());
}

Status SessionLink::Worker::converse() {
  RETURN_IF_ERROR(start_server());
  // A channel of its own for each try: no back-off but ours, and certificates as they are now.
  ASSIGN_OR_RETURN(auto channel, make_channel(server_, trust_, Sharing::kOwn));
  {
    const std::lock_guard lock(mutex_);
    if (stopping_) return cancelled("the session was left");
    outbox_.restart();
    pacer_.restart();
    budget_.restart();
    shown_.restart();
  }
  receiver_.restart();
  last_heard_ = next_heartbeat_ = options_.clock();
  leaving_ = false;
  farewell_.clear();
  const auto stream = LiveStream::start(std::move(channel), user_, wakeup_);
  const Status here = speak_and_listen(*stream);
  stream->cancel();
  while (!stream->status()) {
    stream->take_message();
    wakeup_->wait_for(std::chrono::seconds(1));
  }
  RETURN_IF_ERROR(here);
  if (!farewell_.empty()) return unavailable(farewell_);
  return call_status(server_, *stream->status());
}

// Until the stream has ended, or has to.
Status SessionLink::Worker::speak_and_listen(LiveStream& stream) {
  while (!stream.status()) {
    const Time now = options_.clock();
    if (must_leave(now)) break;
    if (auto message = stream.take_message()) {
      last_heard_ = options_.clock();
      RETURN_IF_ERROR(hear(std::move(*message)));
      wake_user();
      continue;
    }
    if (stream.can_write()) {
      if (const auto message = next_message(now)) {
        RETURN_IF_ERROR(prepare_to_say(*message));
        stream.write(*message);
        continue;
      }
    }
    wakeup_->wait_for(next_deadline() - options_.clock());
  }
  return Status::ok();
}

bool SessionLink::Worker::must_leave(Time now) {
  if (now >= last_heard_ + options_.silence_max) {
    farewell_ =
        "server " + server_ + ": nothing was heard for " + seconds_text(options_.silence_max);
    leaving_ = true;
  }
  const std::lock_guard lock(mutex_);
  return leaving_ || stopping_;
}

std::optional<ClientMessage> SessionLink::Worker::next_message(Time now) {
  const std::lock_guard lock(mutex_);
  const uint64_t previews = outbox_.previews_sent();
  if (auto message = outbox_.next()) {
    if (outbox_.previews_sent() > previews)
      shown_.preview_sent(outbox_.previews_sent(), outbox_.preview_since());
    if (const auto* change = std::get_if<ShowPages>(&*message))
      added_pages_ = outbox_.pages().find(change->added);
    return message;
  }
  const int due = pacer_.due(now);
  // One goes ahead of each credit: so the frame tells how long ago it was asked for.
  if (now >= next_heartbeat_ || (due > 0 && !beat_for_credit_)) {
    beat_for_credit_ = due > 0;
    return heartbeat(now);
  }
  if (due == 0 && !receiver_.has_answers()) return std::nullopt;
  FrameCredit credit = receiver_.take_answers();
  credit.frames = static_cast<uint32_t>(due);
  credit.frame_bytes = budget_.bytes();
  pacer_.granted(now, due);
  beat_for_credit_ = false;
  return credit;
}

// Lays out the pages of a change without the lock: callers do not wait for it.
Status SessionLink::Worker::prepare_to_say(const ClientMessage& message) {
  const auto* change = std::get_if<ShowPages>(&message);
  return change ? receiver_.show(*change, std::exchange(added_pages_, {})) : Status::ok();
}

Heartbeat SessionLink::Worker::heartbeat(Time now) {
  const auto since = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  next_heartbeat_ = now + options_.heartbeat_interval;
  return {static_cast<uint64_t>(since.count())};
}

SessionLink::Worker::Time SessionLink::Worker::next_deadline() {
  const std::lock_guard lock(mutex_);
  return std::min({next_heartbeat_, last_heard_ + options_.silence_max, pacer_.next_due()});
}

void SessionLink::Worker::wait_before_retry(int failures) {
  static thread_local std::minstd_rand random{std::random_device{}()};
  const auto longest =
      std::min(options_.retry_after_max, options_.retry_after_min * (1 << std::min(failures, 10)));
  // Clients of a server that has gone do not come back all at once.
  const auto wait = longest / 2 + longest * static_cast<int>(random() % 100) / 200;
  const Time until = options_.clock() + wait;
  while (options_.clock() < until) {
    {
      const std::lock_guard lock(mutex_);
      if (stopping_) return;
    }
    wakeup_->wait_for(until - options_.clock());
  }
}

void SessionLink::Worker::set_link(LinkState state, const std::string& reason) {
  {
    const std::lock_guard lock(mutex_);
    news_.link = state;
    tell(LinkChanged{state, reason});
  }
  acknowledged_.notify_all();
  wake_user();
}

void SessionLink::Worker::wake_user() {
  if (options_.on_news) options_.on_news();
}

}  // namespace burnish

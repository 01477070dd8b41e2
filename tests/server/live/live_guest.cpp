#include "tests/server/live/live_guest.h"

#include "common/base/check.h"

namespace burnish {

/// Rings when there is something to take.
struct LiveGuest::Bell {
  std::mutex mutex;
  std::condition_variable wake;
  bool rung = false;

  void ring() {
    const std::lock_guard lock(mutex);
    rung = true;
    wake.notify_all();
  }
  bool wait(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex);
    const bool heard = wake.wait_for(lock, time, [this] { return rung; });
    rung = false;
    return heard;
  }
};

template <typename Bell>
static LiveClient join(LiveSessions& sessions, const Greeting& greeting, const Caller& caller,
                       SubscriberWiring wiring, const std::shared_ptr<Bell>& bell) {
  wiring.on_message = [bell] { bell->ring(); };
  wiring.on_dead = [] {};
  auto client = sessions.join(greeting, caller, std::move(wiring), {});
  BURNISH_CHECK(client.is_ok(), client.status().message());
  return std::move(client).value();
}

LiveGuest::LiveGuest(LiveSessions& sessions, const Greeting& greeting, const Caller& caller,
                     SubscriberWiring wiring)
    : LiveGuest(sessions, greeting, caller, std::move(wiring), std::make_shared<Bell>()) {}

LiveGuest::LiveGuest(LiveSessions& sessions, const Greeting& greeting, const Caller& caller,
                     SubscriberWiring wiring, std::shared_ptr<Bell> bell)
    : sessions_(sessions),
      bell_(std::move(bell)),
      client_(join(sessions, greeting, caller, std::move(wiring), bell_)),
      role(client_.welcome.role),
      decoder(client_.subscriber->target->layout) {}

void LiveGuest::leave() {
  if (!client_.session) return;
  sessions_.leave(client_);
  client_ = {};
}

void LiveGuest::take_all() {
  while (auto message = subscriber().take()) {
    if (const auto* frame = std::get_if<LiveFrame>(&*message); frame && !frame->data.empty()) {
      const auto* bytes = reinterpret_cast<const uint8_t*>(frame->data.data());
      const auto seen = decoder.decode({bytes, frame->data.size()});
      BURNISH_CHECK(seen.is_ok(), seen.status().message());
      decoded.push_back(seen.value().sequence);
    }
    received.push_back(std::move(*message));
  }
  finished = subscriber().is_finished();
}

void LiveGuest::run() {
  // Encoders and the journal answer from their own threads, and none of them says when all are
  // done.
  static constexpr std::chrono::milliseconds kAnswerTime{100};
  do {
    while (sessions_.scheduler().run_one()) take_all();
    take_all();
  } while (bell_->wait(kAnswerTime) || session().is_coming_back() ||
           sessions_.scheduler().waiting() > 0);
  take_all();
}

void LiveGuest::settle() {
  for (;;) {
    run();
    const auto frames = all<LiveFrame>();
    if (!frames.empty() && frames.back().stats.settled && decoded.empty()) return;
    subscriber().grant({.frames = 1, .decoded = std::exchange(decoded, {})});
  }
}

}  // namespace burnish

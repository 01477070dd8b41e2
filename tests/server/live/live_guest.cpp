#include "tests/server/live/live_guest.h"

#include <numeric>

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

LiveGuest::LiveGuest(LiveSessions& sessions, MeshStore& store, const Greeting& greeting,
                     const Caller& caller, SubscriberWiring wiring)
    : LiveGuest(sessions, store, greeting, caller, std::move(wiring), std::make_shared<Bell>()) {}

LiveGuest::LiveGuest(LiveSessions& sessions, MeshStore& store, const Greeting& greeting,
                     const Caller& caller, SubscriberWiring wiring, std::shared_ptr<Bell> bell)
    : sessions_(sessions),
      bell_(std::move(bell)),
      client_(join(sessions, greeting, caller, std::move(wiring), bell_)),
      welcome(client_.welcome),
      pages(store.find_pages(welcome.session.scan_id).value(), welcome.session.key.depth) {}

void LiveGuest::show(const std::vector<PageId>& added, const std::vector<PageId>& removed) {
  const ShowPages change{pages.newest_revision() + 1, added, removed};
  pages.show(change);
  const Status status = subscriber().show_pages(change);
  BURNISH_CHECK(status.is_ok(), status.message());
}

void LiveGuest::show_level(int level) {
  std::vector<PageId> numbers(pages.head().level_pages[level]);
  std::iota(numbers.begin(), numbers.end(), pages.head().level_begin(level));
  show(numbers);
}

void LiveGuest::leave() {
  if (!client_.session) return;
  sessions_.leave(client_);
  client_ = {};
}

void LiveGuest::take_all() {
  while (auto message = subscriber().take()) {
    if (const auto* frame = std::get_if<LiveFrame>(&*message); frame && !frame->data.empty()) {
      const auto* bytes = reinterpret_cast<const uint8_t*>(frame->data.data());
      frames.push_back(pages.decode({bytes, frame->data.size()}));
      decoded.push_back(frames.back().sequence);
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
    const auto shown = all<LiveFrame>();
    if (!shown.empty() && shown.back().stats.settled && decoded.empty()) return;
    subscriber().grant({.frames = 1, .decoded = std::exchange(decoded, {})});
  }
}

}  // namespace burnish

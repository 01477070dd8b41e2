#include "server/rpc/reactor/silence_limit.h"

namespace burnish {

using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

void SilenceLimit::start(std::weak_ptr<void> owner, std::function<void(const Status&)> on_silent) {
  const std::lock_guard lock(mutex_);
  owner_ = std::move(owner);
  on_silent_ = std::move(on_silent);
  set_alarm(limit_);
}

void SilenceLimit::wait() {
  const std::lock_guard lock(mutex_);
  waiting_since_ = steady_clock::now();
}

bool SilenceLimit::heard() {
  const std::lock_guard lock(mutex_);
  waiting_since_.reset();
  return !is_silent_;
}

void SilenceLimit::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  alarm_.reset();
}

// One alarm serves many messages: it is set again when it rings, not when a message comes.
void SilenceLimit::set_alarm(milliseconds time) {
  alarm_ = std::make_unique<grpc::Alarm>();  // the last alarm may be ringing and keeps itself alive
  alarm_->Set(std::chrono::system_clock::now() + time, [this, owner = owner_](bool is_time) {
    const auto alive = owner.lock();
    if (is_time && alive) ring();
  });
}

void SilenceLimit::ring() {
  {
    const std::lock_guard lock(mutex_);
    if (stopped_) return;
    const auto silence = waiting_since_
                             ? duration_cast<milliseconds>(steady_clock::now() - *waiting_since_)
                             : milliseconds(0);
    if (silence < limit_) return set_alarm(limit_ - silence);
    is_silent_ = true;
  }
  on_silent_({StatusCode::kDeadlineExceeded,
              "the client has sent nothing for " + std::to_string(limit_.count() / 1000) + " s"});
}

}  // namespace burnish

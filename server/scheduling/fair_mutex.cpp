#include "server/scheduling/fair_mutex.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace burnish {

static constexpr auto kBetweenQuestions = std::chrono::milliseconds(100);

void FairMutex::lock() {
  (void)lock_while([] { return true; });
}

bool FairMutex::try_lock() {
  const std::lock_guard lock(mutex_);
  if (held_) return false;
  last_was_ticket_ = false;
  return held_ = true;
}

bool FairMutex::lock_while(const std::function<bool()>& go_on) {
  std::unique_lock lock(mutex_);
  if (!held_) {
    last_was_ticket_ = false;
    return held_ = true;
  }
  const auto mine = waiters_.emplace(waiters_.end());
  bool goes_on = true;
  while (!mine->is_owner && goes_on) {
    if (mine->wake.wait_for(lock, kBetweenQuestions, [&] { return mine->is_owner; })) break;
    lock.unlock();
    goes_on = go_on();
    lock.lock();
  }
  const bool is_mine = mine->is_owner;  // also if it came during the call of go_on
  waiters_.erase(mine);
  return is_mine;
}

void FairMutex::unlock() {
  std::unique_lock lock(mutex_);
  hand_on(lock);
}

/// Needs: the mutex is held and kept for nobody. Unlocks `lock` if it calls a ticket.
void FairMutex::hand_on(std::unique_lock<std::mutex>& lock) {
  const bool is_tickets_turn = !tickets_.empty() && (waiters_.empty() || !last_was_ticket_);
  last_was_ticket_ = is_tickets_turn;
  if (is_tickets_turn) {
    kept_for_ = tickets_.front();
    tickets_.pop_front();
    const std::function<void()> call = kept_for_->call_;  // the ticket may end meanwhile
    lock.unlock();
    call();
  } else if (!waiters_.empty()) {
    // A waiter removes itself from the list, and only then can it hand on.
    waiters_.front().is_owner = true;
    waiters_.front().wake.notify_one();
  } else {
    held_ = false;
  }
}

void FairMutex::let_ticket_pass() {
  std::unique_lock lock(mutex_);
  if (tickets_.empty()) return;
  const auto mine = waiters_.emplace(waiters_.begin());
  last_was_ticket_ = false;
  hand_on(lock);
  lock.lock();
  mine->wake.wait(lock, [&] { return mine->is_owner; });
  waiters_.erase(mine);
}

bool FairMutex::Ticket::take() {
  const std::lock_guard lock(mutex_.mutex_);
  if (mutex_.kept_for_ == this) {
    mutex_.kept_for_ = nullptr;
    return true;
  }
  if (!mutex_.held_) {
    mutex_.last_was_ticket_ = true;
    return mutex_.held_ = true;
  }
  const bool is_in_line = std::ranges::find(mutex_.tickets_, this) != mutex_.tickets_.end();
  if (!is_in_line) mutex_.tickets_.push_back(this);
  return false;
}

void FairMutex::Ticket::leave() {
  std::unique_lock lock(mutex_.mutex_);
  std::erase(mutex_.tickets_, this);
  if (mutex_.kept_for_ != this) return;
  mutex_.kept_for_ = nullptr;
  mutex_.hand_on(lock);
}

}  // namespace burnish

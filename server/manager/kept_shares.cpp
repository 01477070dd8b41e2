#include "server/manager/kept_shares.h"

#include <algorithm>
#include <utility>

namespace burnish {

KeptShares::Part& KeptShares::Part::operator=(Part&& other) noexcept {
  give_back();
  state_ = std::exchange(other.state_, nullptr);
  user_ = std::move(other.user_);
  bytes_ = std::exchange(other.bytes_, 0);
  return *this;
}

KeptShares::Part::~Part() {
  give_back();
}

void KeptShares::Part::give_back() {
  if (!state_) return;
  const std::lock_guard lock(state_->mutex);
  const auto share = state_->by_user.find(user_);
  --share->second.sessions;
  share->second.history_bytes -= bytes_;
  if (share->second.sessions == 0) state_->by_user.erase(share);
}

void KeptShares::Part::set_history_bytes(uint64_t bytes) {
  if (!state_) return;
  const std::lock_guard lock(state_->mutex);
  uint64_t& sum = state_->by_user[user_].history_bytes;
  sum = sum - bytes_ + bytes;
  bytes_ = bytes;
}

uint64_t KeptShares::Part::history_bytes() const {
  if (!state_) return 0;
  const std::lock_guard lock(state_->mutex);
  return bytes_;
}

KeptShares::Part KeptShares::add(const std::string& user, uint64_t history_bytes) {
  Part part;
  part.state_ = state_;
  part.user_ = user;
  part.bytes_ = history_bytes;
  const std::lock_guard lock(state_->mutex);
  Share& share = state_->by_user[user];
  ++share.sessions;
  share.history_bytes += history_bytes;
  return part;
}

KeptShares::Share KeptShares::of(const std::string& user) const {
  const std::lock_guard lock(state_->mutex);
  const auto share = state_->by_user.find(user);
  return share == state_->by_user.end() ? Share{} : share->second;
}

KeptShares::Share KeptShares::largest() const {
  const std::lock_guard lock(state_->mutex);
  Share most;
  for (const auto& [user, share] : state_->by_user) {
    if (user.empty()) continue;
    most.sessions = std::max(most.sessions, share.sessions);
    most.history_bytes = std::max(most.history_bytes, share.history_bytes);
  }
  return most;
}

}  // namespace burnish

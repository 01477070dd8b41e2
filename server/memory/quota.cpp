#include "server/memory/quota.h"

#include <algorithm>
#include <utility>

namespace burnish {

struct Quota::State {
  const std::string what;
  const std::string key;
  const uint64_t max;
  std::mutex mutex;
  std::map<std::string, uint64_t> taken;  // a holder of nothing is not in it

  Status take(const std::string& holder, uint64_t more) {
    const std::lock_guard lock(mutex);
    const uint64_t has = of(holder);
    if (more <= max - std::min(has, max)) {
      if (more > 0) taken[holder] = has + more;
      return Status::ok();
    }
    return resource_exhausted(holder + " has " + std::to_string(has) + " " + what + " and needs " +
                              std::to_string(more) + " more; " + key + " is " +
                              std::to_string(max));
  }

  void give_back(const std::string& holder, uint64_t amount) {
    if (amount == 0) return;
    const std::lock_guard lock(mutex);
    const auto entry = taken.find(holder);
    entry->second -= amount;
    if (entry->second == 0) taken.erase(entry);
  }

 private:
  uint64_t of(const std::string& holder) const {
    const auto found = taken.find(holder);
    return found == taken.end() ? 0 : found->second;
  }
};

Quota::Share::Share(Share&& other) noexcept
    : state_(std::exchange(other.state_, nullptr)),
      holder_(std::move(other.holder_)),
      amount_(std::exchange(other.amount_, 0)) {}

Quota::Share& Quota::Share::operator=(Share&& other) noexcept {
  give_back();
  state_ = std::exchange(other.state_, nullptr);
  holder_ = std::move(other.holder_);
  amount_ = std::exchange(other.amount_, 0);
  return *this;
}

Quota::Share::~Share() {
  give_back();
}

void Quota::Share::give_back() {
  if (state_) state_->give_back(holder_, amount_);
}

Status Quota::Share::resize(uint64_t amount) {
  BURNISH_CHECK(state_ != nullptr, "a share of nothing cannot grow");
  if (amount > amount_) {
    RETURN_IF_ERROR(state_->take(holder_, amount - amount_));
  } else {
    state_->give_back(holder_, amount_ - amount);
  }
  amount_ = amount;
  return Status::ok();
}

Quota::Quota(std::string what, std::string key, uint64_t max)
    : state_(new State{std::move(what), std::move(key), max, {}, {}}) {}

Result<Quota::Share> Quota::take(const std::string& holder, uint64_t amount) {
  Share share(state_, holder, 0);  // its memory first: a taken amount must have an owner
  RETURN_IF_ERROR(share.resize(amount));
  return share;
}

uint64_t Quota::taken() const {
  const std::lock_guard lock(state_->mutex);
  uint64_t sum = 0;
  for (const auto& [holder, amount] : state_->taken) sum += amount;
  return sum;
}

uint64_t Quota::max() const {
  return state_->max;
}

}  // namespace burnish

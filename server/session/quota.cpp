#include "server/session/quota.h"

#include <utility>

namespace burnish {

struct Quota::State {
  const std::string what;
  const std::string key;
  const uint64_t max;
  std::mutex mutex;
  std::map<std::string, uint64_t> taken;  // nobody is kept with nothing
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
  if (!state_) return;
  const std::lock_guard lock(state_->mutex);
  const auto entry = state_->taken.find(holder_);
  entry->second -= amount_;
  if (entry->second == 0) state_->taken.erase(entry);
}

Quota::Quota(std::string what, std::string key, uint64_t max)
    : state_(new State{std::move(what), std::move(key), max, {}, {}}) {}

Result<Quota::Share> Quota::take(const std::string& holder, uint64_t amount) {
  if (amount == 0) return Share();
  const std::lock_guard lock(state_->mutex);
  const auto found = state_->taken.find(holder);
  const uint64_t has = found == state_->taken.end() ? 0 : found->second;
  if (amount > state_->max || has > state_->max - amount)
    return resource_exhausted(holder + " has " + std::to_string(has) + " " + state_->what +
                              " and asks for " + std::to_string(amount) + " more; " + state_->key +
                              " is " + std::to_string(state_->max));
  state_->taken[holder] = has + amount;
  return Share(state_, holder, amount);
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

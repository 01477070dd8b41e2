#include "client/live/server_route.h"

#include <algorithm>
#include <utility>

namespace burnish {

std::string ServerRoute::address() const {
  const LiveGuard lock(mutex_);
  return address_;
}

void ServerRoute::move_to(const std::string& address) {
  const LiveGuard lock(mutex_);
  address_ = address;
}

void ServerRoute::learn(std::vector<std::string> fleet) {
  const LiveGuard lock(mutex_);
  fleet_ = std::move(fleet);
}

// A client that reaches the fleet by a name of its own, not in the list, begins with the first.
void ServerRoute::give_up(const std::string& address) {
  const LiveGuard lock(mutex_);
  if (address != address_ || fleet_.empty()) return;
  const auto here = std::ranges::find(fleet_, address);
  const bool is_last = here == fleet_.end() || here + 1 == fleet_.end();
  address_ = is_last ? fleet_.front() : *(here + 1);
}

}  // namespace burnish

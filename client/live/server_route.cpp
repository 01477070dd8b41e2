#include "client/live/server_route.h"

#include <algorithm>
#include <utility>

namespace burnish {

ServerPlace ServerRoute::place() const {
  const LiveGuard lock(mutex_);
  return place_;
}

void ServerRoute::move_to(const ServerPlace& place) {
  const LiveGuard lock(mutex_);
  if (!place.address.empty()) place_.address = place.address;
  place_.node = place.node;
}

void ServerRoute::learn(std::vector<std::string> fleet) {
  const LiveGuard lock(mutex_);
  fleet_ = std::move(fleet);
}

// A client that reaches the fleet by a name of its own, not in the list, begins with the first.
void ServerRoute::give_up(const std::string& address) {
  const LiveGuard lock(mutex_);
  if (address != place_.address) return;
  place_.node.clear();
  if (fleet_.empty()) return;
  const auto here = std::ranges::find(fleet_, address);
  const bool is_last = here == fleet_.end() || here + 1 == fleet_.end();
  place_ = {is_last ? fleet_.front() : *(here + 1), {}};
}

}  // namespace burnish

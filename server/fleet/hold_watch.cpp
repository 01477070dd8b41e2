#include "server/fleet/hold_watch.h"

#include <algorithm>

namespace burnish {

/// Time between the stop and the lease's end: for the news to reach the clients.
static std::chrono::milliseconds reserve_of(const LeaseTimes& times) {
  return std::min<std::chrono::milliseconds>(std::chrono::seconds(2), times.lease / 4);
}

HoldWatch::HoldWatch(const LeaseTimes& times, LeaseLeft lease_left, PauseWatch::BootClock clock)
    : left_at_least_(std::min(reserve_of(times), times.lease - times.alone)),
      lease_left_(std::move(lease_left)),
      pauses_(times.lease - reserve_of(times), std::move(clock)) {}

Status HoldWatch::check() {
  if (pauses_.was_paused())
    return unavailable("the server stood still for too long; another one may have its sessions");
  if (lease_left_() < left_at_least_)
    return unavailable("the server does not reach the database; another one may have its sessions");
  return Status::ok();
}

}  // namespace burnish

#pragma once

#include <chrono>
#include <functional>

#include "common/base/status.h"
#include "server/fleet/membership.h"
#include "server/fleet/pause_watch.h"

namespace burnish {

/// Says when this server shows its sessions no more, as others may have them: its process stood
/// still for nearly as long as a lease, or no heartbeat has succeeded for as long and for
/// LeaseTimes::alone. A server cannot know whether the database is away from itself alone. Only its
/// own clocks count. Thread-safe.
class HoldWatch {
 public:
  /// Returns how long the lease lasts if no heartbeat succeeds any more.
  using LeaseLeft = std::function<std::chrono::duration<double>()>;

  HoldWatch(const LeaseTimes& times, LeaseLeft lease_left,
            PauseWatch::BootClock clock = PauseWatch::since_boot);

  /// Fails with `unavailable`: once after a pause; and, without the database, from two seconds
  /// before the lease's end, or a quarter of a short lease, but not before `alone` is over, until a
  /// heartbeat succeeds. Somebody must ask more often.
  Status check();

 private:
  const std::chrono::duration<double> left_at_least_;
  const LeaseLeft lease_left_;
  PauseWatch pauses_;
};

}  // namespace burnish

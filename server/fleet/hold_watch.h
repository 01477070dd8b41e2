#pragma once

#include <chrono>
#include <functional>

#include "common/base/status.h"
#include "server/fleet/membership.h"
#include "server/fleet/pause_watch.h"

namespace burnish {

/// Says when others may have this server's sessions soon: its process stood still, or no heartbeat
/// has succeeded, for nearly as long as a lease. Only this server's clocks count, so it is early
/// enough if the database is away from this server alone. Thread-safe.
class HoldWatch {
 public:
  /// Returns how long the lease lasts if no heartbeat succeeds any more.
  using LeaseLeft = std::function<std::chrono::duration<double>()>;

  HoldWatch(const LeaseTimes& times, LeaseLeft lease_left,
            PauseWatch::BootClock clock = PauseWatch::since_boot);

  /// Fails with `unavailable`: once after a pause; and from two seconds before the lease's end, or
  /// a quarter of a short lease, until a heartbeat succeeds. Somebody must ask more often.
  Status check();

 private:
  const std::chrono::duration<double> reserve_;
  const LeaseLeft lease_left_;
  PauseWatch pauses_;
};

}  // namespace burnish

#pragma once

#include <chrono>
#include <csignal>
#include <functional>

#include "common/base/clock.h"
#include "server/process/device_watch.h"
#include "server/rpc/server.h"

namespace burnish {

/// SIGTERM, SIGINT and SIGHUP, blocked for all threads so that one can wait for them.
/// Call it before there are other threads.
sigset_t block_signals();

struct DaemonOptions {
  std::chrono::seconds drain_time{10};
  std::chrono::seconds idle_max{0};  ///< without use, until it ends by itself; 0: never
  /// Between two looks at all that may have changed.
  std::chrono::milliseconds tick{250};
  Clock clock = std::chrono::steady_clock::now;
  /// What is to be done all the time; certificates and users are read again in any case when the
  /// server was told to.
  std::function<void(bool in_any_case)> tend;
};

/// Watches over a serving server until SIGTERM, SIGINT or too long without use has drained it; a
/// second such signal ends the process at once. SIGHUP reloads. Reports to the service manager
/// throughout. Fails: what the device failed with; by then the health service has said NOT_SERVING.
Status watch_over(Server& server, const DeviceWatch& device, const sigset_t& signals,
                  const DaemonOptions& options);

}  // namespace burnish

#pragma once

#include <chrono>
#include <csignal>
#include <functional>

#include "common/base/clock.h"
#include "server/live/successors.h"
#include "server/process/device_watch.h"
#include "server/rpc/server.h"

namespace burnish {

/// Blocks SIGTERM, SIGINT and SIGHUP for all threads, so that one thread can wait for them. Call it
/// before there are other threads.
sigset_t block_signals();

struct DaemonOptions {
  std::chrono::seconds drain_time{10};
  std::chrono::seconds idle_max{0};  ///< without use until it ends by itself; 0: never
  /// Returns whether the server's owner is gone, so that it ends by itself. May be empty.
  std::function<bool()> is_abandoned;
  /// Time between two checks for changes.
  std::chrono::milliseconds tick{250};
  Clock clock = std::chrono::steady_clock::now;
  /// Work for every tick. `in_any_case`: a signal asks to read certificates and users again.
  std::function<void(bool in_any_case)> tend;
  /// Called first when the server drains. Returns the servers that take its sessions. May be empty.
  std::function<Successors()> find_successors;
};

/// Watches over a serving server until SIGTERM, SIGINT, a long time without use or the end of its
/// owner has drained it. A second such signal ends the process at once. SIGHUP reloads. Reports to
/// the service manager throughout. Fails: with the device's failure; by then the health service has
/// said NOT_SERVING.
Status watch_over(Server& server, const DeviceWatch& device, const sigset_t& signals,
                  const DaemonOptions& options);

}  // namespace burnish

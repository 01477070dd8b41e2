#pragma once

#include <chrono>
#include <string_view>

namespace burnish {

/// Tells the service manager the state of the process, as systemd's sd_notify(3) describes:
/// "READY=1", "STOPPING=1", "WATCHDOG=1", "STATUS=...". Does nothing without $NOTIFY_SOCKET.
void notify_service_manager(std::string_view state);

/// Returns the interval of "WATCHDOG=1": half of the manager's limit; 0: never.
std::chrono::microseconds watchdog_interval();

}  // namespace burnish

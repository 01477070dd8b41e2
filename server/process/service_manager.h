#pragma once

#include <chrono>
#include <string_view>

namespace burnish {

/// Tells the service manager how the process is, as systemd's sd_notify(3) describes: "READY=1",
/// "STOPPING=1", "WATCHDOG=1", "STATUS=...". Does nothing where $NOTIFY_SOCKET is not set.
void notify_service_manager(std::string_view state);

/// How often the manager wants to hear "WATCHDOG=1": half of what it allows; 0: never.
std::chrono::microseconds watchdog_interval();

}  // namespace burnish

#include "server/fleet/pause_watch.h"

#include <ctime>

namespace burnish {

PauseWatch::Nanoseconds PauseWatch::since_boot() {
  timespec now{};
  ::clock_gettime(CLOCK_BOOTTIME, &now);
  return std::chrono::seconds(now.tv_sec) + Nanoseconds(now.tv_nsec);
}

}  // namespace burnish

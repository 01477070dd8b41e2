#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace burnish {

/// A kernel or copy of a device. Units: nanoseconds of one clock.
struct TracedWork {
  std::string name;  ///< as the linker knows it; "copy"
  uint64_t start, end;
};

/// What the device does while `work` is done, in the order in which it starts; nothing where this
/// build has no CUPTI. Needs: work waits for the device. From the first call on the process's other
/// calls of CUDA take longer.
std::vector<TracedWork> trace_device(const std::function<void()>& work);

/// How long the device is busy, with pauses between, where it waits for the host, left out.
/// Needs: in order of their starts. Units: microseconds.
double microseconds_of(const std::vector<TracedWork>& works);

}  // namespace burnish

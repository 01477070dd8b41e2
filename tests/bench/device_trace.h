#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace burnish {

/// A kernel or copy of a device. Units: nanoseconds of one clock.
struct TracedWork {
  std::string name;  ///< the linker's name, or "copy"
  uint64_t start, end;
};

/// Returns the device's work during `work`, in the order of its starts; nothing in a build without
/// CUPTI. Needs: work waits for the device. After the first call the process's other calls of CUDA
/// are slower.
std::vector<TracedWork> trace_device(const std::function<void()>& work);

/// Returns how long the device is busy, without the pauses in which it waits for the host. Needs:
/// works in the order of their starts. Units: microseconds.
double microseconds_of(const std::vector<TracedWork>& works);

}  // namespace burnish

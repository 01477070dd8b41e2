#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace burnish {

/// One kernel that a device ran. Units: nanoseconds of one clock.
struct TracedKernel {
  std::string name;  ///< as the linker knows it
  uint64_t start, end;
};

/// The kernels that run while `work` is done, in the order in which they start; none where this
/// build has no CUPTI. Needs: work waits for the device. From the first call on the process's other
/// calls of CUDA take longer.
std::vector<TracedKernel> trace_kernels(const std::function<void()>& work);

/// From the first start to the last end. Units: microseconds.
double microseconds_of(const std::vector<TracedKernel>& kernels);

}  // namespace burnish

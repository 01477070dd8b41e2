#include "server/solver/device_probe.h"

#include <algorithm>

#include "server/solver/cuda/cuda_backend.h"

namespace burnish {

bool has_device(BackendKind backend) {
  if (backend == BackendKind::kCpu || !cuda_compiled()) return false;
  // Asks only once: a device that fails later must not look like a missing one.
  static const bool is_there = cuda_device().is_ok();
  return is_there;
}

uint64_t device_bytes_max(BackendKind backend, int devices) {
  if (!has_device(backend)) return 0;
  const auto there = static_cast<int>(cuda_memory_by_device().size());
  const int sharing = devices == 0 ? there : std::min(devices, there);
  return static_cast<uint64_t>(sharing) * cuda_memory_max();
}

Result<std::string> say_where_solved(BackendKind backend) {
  if (backend == BackendKind::kCpu) return std::string("the processors (requested)");
  const Result<std::string> device = cuda_device();
  if (device.is_ok()) return "CUDA (" + *device + ")";
  if (backend == BackendKind::kCuda)
    return failed_precondition("backend cuda: " + device.status().message());
  return "the processors (" + device.status().message() + ")";
}

Status probe_device(BackendKind backend) {
  return has_device(backend) ? probe_cuda_device() : Status::ok();
}

}  // namespace burnish

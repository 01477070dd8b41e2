#include "server/solver/device_probe.h"

#include "server/solver/cuda/cuda_backend.h"

namespace burnish {

bool has_device(BackendKind backend) {
  if (backend == BackendKind::kCpu || !cuda_compiled()) return false;
  // Asks only once: a device that fails later must not look like a missing one.
  static const bool is_there = cuda_device().is_ok();
  return is_there;
}

std::string say_where_solved(BackendKind backend) {
  if (backend == BackendKind::kCpu) return "the processors (requested)";
  const Result<std::string> device = cuda_device();
  if (device.is_ok()) return "CUDA (" + *device + ")";
  return (backend == BackendKind::kAuto ? "the processors (" : "nothing (") +
         device.status().message() + ")";
}

Status probe_device(BackendKind backend) {
  return has_device(backend) ? probe_cuda_device() : Status::ok();
}

}  // namespace burnish

#include "server/solver/device_probe.h"

#include "server/solver/cuda/cuda_backend.h"

namespace burnish {

Status probe_device(BackendKind backend) {
  if (backend == BackendKind::kCpu || !cuda_compiled()) return Status::ok();
  // Whether there is a device is asked once: a device that fails later must not look like none.
  static const bool has_device = cuda_device().is_ok();
  return has_device ? probe_cuda_device() : Status::ok();
}

}  // namespace burnish

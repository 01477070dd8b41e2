#include <deque>

#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/device/stream.h"

namespace burnish {

bool cuda_compiled() {
  return true;
}

static std::string why_none(cudaError_t error) {
  if (error == cudaErrorInsufficientDriver)
    return "the driver is missing or older than CUDA " + std::to_string(CUDART_VERSION / 1000);
  return error == cudaSuccess ? "this machine has none" : cudaGetErrorString(error);
}

Result<std::string> cuda_device() {
  int count = 0;
  const cudaError_t error = cudaGetDeviceCount(&count);
  if (error != cudaSuccess || count == 0)
    return failed_precondition("no CUDA device: " + why_none(error));
  cudaDeviceProp device;
  const Status found = cuda::cuda_status(cudaGetDeviceProperties(&device, 0), "asking the device");
  if (!found.is_ok()) return failed_precondition(found.message());
  return std::string(device.name) + ", " + std::to_string(device.totalGlobalMem >> 20) + " MiB" +
         (count > 1 ? ", the first of " + std::to_string(count) : "");
}

namespace {

class DeviceProbe {
 public:
  explicit DeviceProbe(int device) : stream_(device) {
    stream_.get();
    stream_.check(cudaMallocHost(&word_, sizeof(int)), "pinning a word");
  }
  // The device writes a word of the host: the device's own memory may be full.
  Status run() {
    if (stream_.is_ok() &&
        stream_.check(cudaMemsetAsync(word_, 0, sizeof(int), stream_.get()), "probing"))
      stream_.synchronize();
    return stream_.status();
  }

 private:
  cuda::Stream stream_;  // keeps its first failure, as the device does
  void* word_ = nullptr;
};

}  // namespace

Status probe_cuda_device() {
  static std::deque<DeviceProbe> probes;
  while (probes.size() < cuda_memory_by_device().size())
    probes.emplace_back(static_cast<int>(probes.size()));
  for (DeviceProbe& probe : probes) RETURN_IF_ERROR(probe.run());
  return Status::ok();
}

}  // namespace burnish

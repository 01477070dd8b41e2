#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/stream.h"

namespace burnish {

bool cuda_compiled() {
  return true;
}

static std::string why_none(cudaError_t error) {
  if (error == cudaErrorInsufficientDriver)
    return "the driver is missing or older than CUDA " + std::to_string(CUDART_VERSION / 1000);
  return error == cudaSuccess ? "none is there" : cudaGetErrorString(error);
}

Result<std::string> cuda_device() {
  int count = 0;
  const cudaError_t error = cudaGetDeviceCount(&count);
  if (error != cudaSuccess || count == 0)
    return failed_precondition("no CUDA device: " + why_none(error));
  cudaDeviceProp device;
  const Status found = cuda::cuda_status(cudaGetDeviceProperties(&device, 0), "asking the device");
  if (!found.is_ok()) return failed_precondition(found.message());
  return std::string(device.name) + ", " + std::to_string(device.totalGlobalMem >> 20) + " MiB";
}

Status probe_cuda_device() {
  static cuda::Stream stream;  // its first failure stays, as the device's does
  // The device writes a word of ours: its own memory may be full.
  static void* word = nullptr;
  static const bool has_word = stream.check(cudaMallocHost(&word, sizeof(int)), "pinning a word");
  if (has_word && stream.check(cudaMemsetAsync(word, 0, sizeof(int), stream.get()), "probing"))
    stream.synchronize();
  return stream.status();
}

}  // namespace burnish

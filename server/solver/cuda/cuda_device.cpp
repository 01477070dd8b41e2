#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/stream.h"

namespace burnish {

bool cuda_compiled() { return true; }

Result<std::string> cuda_device() {
  int count = 0;
  const cudaError_t error = cudaGetDeviceCount(&count);
  if (error != cudaSuccess || count == 0) {
    cudaGetLastError();
    return failed_precondition(std::string("no CUDA device: ") +
                               (error == cudaSuccess ? "none is there" : cudaGetErrorString(error)));
  }
  cudaDeviceProp device;
  const Status found = cuda::cuda_status(cudaGetDeviceProperties(&device, 0), "asking the device");
  if (!found.is_ok()) return failed_precondition(found.message());
  return std::string(device.name) + ", " + std::to_string(device.totalGlobalMem >> 20) + " MiB";
}

}  // namespace burnish

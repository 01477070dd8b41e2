#include "server/solver/cuda/device_memory.h"

namespace burnish::cuda {

static Status refused(uint64_t bytes) {
  size_t free = 0, total = 0;
  cudaMemGetInfo(&free, &total);
  return resource_exhausted("the device has no room for " + std::to_string(bytes) + " bytes: " +
                            std::to_string(free) + " of " + std::to_string(total) + " are free");
}

void* allocate(Stream& stream, uint64_t bytes) {
  void* memory = nullptr;
  if (!stream.is_ok() || bytes == 0) return nullptr;
  const cudaError_t error = cudaMalloc(&memory, bytes);
  if (error != cudaErrorMemoryAllocation) {
    stream.check(error, "taking memory");
    return memory;
  }
  cudaGetLastError();  // this one does not stick
  stream.check(refused(bytes));
  return nullptr;
}

}  // namespace burnish::cuda

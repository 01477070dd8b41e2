#include "server/solver/cuda/device_memory.h"

#include <atomic>
#include <limits>
#include <mutex>

#include "server/solver/cuda/cuda_backend.h"

namespace burnish {

static std::atomic<uint64_t> budget = std::numeric_limits<uint64_t>::max();
static std::atomic<uint64_t> used = 0;

void set_cuda_memory_budget(uint64_t bytes) {
  budget = bytes;
}
uint64_t cuda_memory_used() {
  return used;
}

namespace cuda {

static Status beyond_budget(uint64_t bytes) {
  return resource_exhausted("the solver has no room for " + std::to_string(bytes) +
                            " bytes on the device: it uses " + std::to_string(used) +
                            " and may use " + std::to_string(budget));
}

static Status beyond_device(uint64_t bytes) {
  size_t free = 0, total = 0;
  cudaMemGetInfo(&free, &total);
  return resource_exhausted("the device has no room for " + std::to_string(bytes) + " bytes: " +
                            std::to_string(free) + " of " + std::to_string(total) + " are free");
}

// What sessions give back stays in the driver's pool for the next one.
static void keep_freed_memory() {
  static std::once_flag once;
  std::call_once(once, [] {
    int device = 0;
    cudaMemPool_t pool = nullptr;
    if (cudaGetDevice(&device) != cudaSuccess ||
        cudaDeviceGetDefaultMemPool(&pool, device) != cudaSuccess)
      return;
    uint64_t all = std::numeric_limits<uint64_t>::max();
    cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &all);
  });
}

void* allocate(Stream& stream, uint64_t bytes) {
  void* memory = nullptr;
  if (!stream.is_ok() || bytes == 0) return nullptr;
  if (used.fetch_add(bytes) + bytes > budget) {
    used -= bytes;
    stream.check(beyond_budget(bytes));
    return nullptr;
  }
  keep_freed_memory();
  const cudaError_t error = cudaMallocAsync(&memory, bytes, stream.get());
  if (error == cudaSuccess) return memory;
  used -= bytes;
  if (error == cudaErrorMemoryAllocation) {
    cudaGetLastError();  // this one does not stick
    stream.check(beyond_device(bytes));
  } else {
    stream.check(error, "taking memory");
  }
  return nullptr;
}

void release(void* memory, uint64_t bytes) {
  if (memory == nullptr) return;
  cudaFree(memory);
  used -= bytes;
}

void* allocate_pinned(Stream& stream, uint64_t bytes) {
  void* memory = nullptr;
  if (stream.is_ok() && bytes > 0)
    stream.check(cudaMallocHost(&memory, bytes), "taking memory of the host");
  return memory;
}

void release_pinned(void* memory) {
  if (memory != nullptr) cudaFreeHost(memory);
}

}  // namespace cuda

}  // namespace burnish

#include "server/solver/cuda/device/device_memory.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <numeric>

#include "server/solver/cuda/cuda_backend.h"

namespace burnish {

static std::atomic<uint64_t> budget = std::numeric_limits<uint64_t>::max();

// One number per device.
static std::vector<std::atomic<uint64_t>>& used() {
  static std::vector<std::atomic<uint64_t>> by_device([] {
    int count = 0;
    return cudaGetDeviceCount(&count) == cudaSuccess ? std::max(count, 1) : 1;
  }());
  return by_device;
}

void set_cuda_memory_budget(uint64_t bytes) {
  budget = bytes;
}
uint64_t cuda_memory_max() {
  uint64_t most = budget;
  for (int device = 0; device < static_cast<int>(used().size()); ++device) {
    cudaDeviceProp properties = {};
    if (cudaGetDeviceProperties(&properties, device) != cudaSuccess) return 0;
    most = std::min<uint64_t>(most, properties.totalGlobalMem);
  }
  return most;
}
std::vector<uint64_t> cuda_memory_by_device() {
  return {used().begin(), used().end()};
}
uint64_t cuda_memory_used() {
  const std::vector<uint64_t> by_device = cuda_memory_by_device();
  return std::accumulate(by_device.begin(), by_device.end(), uint64_t{0});
}

namespace cuda {

static Status beyond_budget(int device, uint64_t bytes) {
  return resource_exhausted("the solver has no room for " + std::to_string(bytes) +
                            " bytes on the device: it uses " + std::to_string(used()[device]) +
                            " and may use " + std::to_string(budget));
}

static Status beyond_device(uint64_t bytes) {
  size_t free = 0, total = 0;
  cudaMemGetInfo(&free, &total);
  return resource_exhausted("the device has no room for " + std::to_string(bytes) + " bytes: " +
                            std::to_string(free) + " of " + std::to_string(total) + " are free");
}

// Keeps freed memory of sessions in the driver's pool for the next session.
static void keep_freed_memory() {
  static std::once_flag once;
  std::call_once(once, [] {
    for (int device = 0; device < static_cast<int>(used().size()); ++device) {
      cudaMemPool_t pool = nullptr;
      if (cudaDeviceGetDefaultMemPool(&pool, device) != cudaSuccess) return;
      uint64_t all = std::numeric_limits<uint64_t>::max();
      cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &all);
    }
  });
}

void* allocate(Stream& stream, uint64_t bytes) {
  void* memory = nullptr;
  if (!stream.is_ok() || bytes == 0) return nullptr;
  std::atomic<uint64_t>& used_there = used()[stream.device()];
  if (used_there.fetch_add(bytes) + bytes > budget) {
    used_there -= bytes;
    stream.check(beyond_budget(stream.device(), bytes));
    return nullptr;
  }
  keep_freed_memory();
  const cudaError_t error = cudaMallocAsync(&memory, bytes, stream.get());
  if (error == cudaSuccess) return memory;
  used_there -= bytes;
  if (error == cudaErrorMemoryAllocation) {
    cudaGetLastError();  // this error does not stay
    stream.check(beyond_device(bytes));
  } else {
    stream.check(error, "taking memory");
  }
  return nullptr;
}

void release(int device, void* memory, uint64_t bytes) {
  if (memory == nullptr) return;
  cudaFree(memory);
  used()[device] -= bytes;
}

void* allocate_pinned(Stream& stream, uint64_t bytes) {
  void* memory = nullptr;
  stream.get();
  if (stream.is_ok() && bytes > 0)
    stream.check(cudaMallocHost(&memory, bytes), "taking memory of the host");
  return memory;
}

void release_pinned(void* memory) {
  if (memory != nullptr) cudaFreeHost(memory);
}

}  // namespace cuda

}  // namespace burnish

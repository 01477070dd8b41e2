#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "server/solver/cycle/backend.h"
#include "server/solver/cycle/halo_lists.h"
#include "server/solver/cycle/multigrid.h"
#include "server/solver/cycle/smoother_names.h"

namespace burnish {

/// Returns whether this build has the CUDA backend. Without it the functions below fail and say so.
bool cuda_compiled();

/// Returns the name and memory of the device that a backend would use, and the number of devices.
/// Fails: failed_precondition: not in this build, no driver, no device.
Result<std::string> cuda_device();

/// Limits the memory of all sessions and meshes on each device. By default they may take all of it.
void set_cuda_memory_budget(uint64_t bytes);
uint64_t cuda_memory_max();                     ///< bytes of the smallest device that may be used
uint64_t cuda_memory_used();                    ///< bytes on all devices
std::vector<uint64_t> cuda_memory_by_device();  ///< bytes; one number if there is no device

/// Gives each device a trifle to do and waits for it. Fails: internal_error; CUDA's errors stay.
Status probe_cuda_device();

/// The smoothers of the CUDA backend, the default first.
inline constexpr Smoother kCudaSmoothers[] = {Smoother::kSchwarz, Smoother::kGaussSeidel};

/// Makes the CUDA backend on the device with the least memory in use: float32 V-cycle, double outer
/// iteration. On one device the same input gives the same bits. Fails: failed_precondition (no
/// device), unimplemented (smoother), resource_exhausted (device memory, with the numbers).
Result<std::unique_ptr<Backend>> make_cuda_backend(Multigrid on, Smoother smoother);

/// A part of a scan for one of several devices, and what it exchanges with the others.
struct CudaShard {
  Multigrid on;                       ///< without its integrals
  std::span<const int32_t> cells;     ///< of the finest depth, in the whole scan
  std::span<const HaloLists> depths;  ///< from the border depth on
  const BorderLists* border;
};

/// The backends of all shards, and the halos that they need to the end.
struct CudaShards {
  std::shared_ptr<void> halos;
  std::vector<std::unique_ptr<Backend>> backends;
};

/// Parts that all shards share.
struct CudaShardGroup {
  int border;  ///< depth
  bool has_patches;
  std::span<const CellIntegrals> integrals;                           ///< of the whole scan
  std::function<void(const std::function<void()>&)> arrive_and_wait;  ///< see multi/lock_step.h
};

/// Makes a backend of each shard, with the smoother kSchwarz, on the devices in turn. Fails: as
/// make_cuda_backend(); failed_precondition if a device cannot read another's memory.
Result<CudaShards> make_cuda_shards(const CudaShardGroup& group, std::span<CudaShard> shards);
inline constexpr int kCudaShardsMax = 16;

}  // namespace burnish

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "server/solver/cycle/backend.h"
#include "server/solver/cycle/multigrid.h"
#include "server/solver/cycle/smoother_names.h"

namespace burnish {

/// Whether this build has the CUDA backend. Without it the functions below fail and say so.
bool cuda_compiled();

/// Name and memory of the device that a backend would use, and how many such there are.
/// Fails: failed_precondition: not in this build, no driver, no device.
Result<std::string> cuda_device();

/// Limits what sessions and meshes together take of each device's memory; without it, all of it.
void set_cuda_memory_budget(uint64_t bytes);
uint64_t cuda_memory_used();                    ///< bytes, of all devices
std::vector<uint64_t> cuda_memory_by_device();  ///< bytes; one number where there is no device

/// Lets each device do a trifle and waits for it. Fails: internal_error; CUDA's errors stick.
Status probe_cuda_device();

/// The smoothers that the CUDA backend has, the default first.
inline constexpr Smoother kCudaSmoothers[] = {Smoother::kSchwarz, Smoother::kGaussSeidel};

/// The CUDA backend on the device that holds the least: float32 V-cycle, double outer iteration; on
/// one device the same input gives the same bits. Fails: failed_precondition (no device),
/// unimplemented (smoother), resource_exhausted (device memory, with the numbers).
Result<std::unique_ptr<Backend>> make_cuda_backend(Multigrid on, Smoother smoother);

}  // namespace burnish

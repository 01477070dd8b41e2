#pragma once

#include <memory>
#include <string>

#include "common/base/status.h"
#include "server/solver/backend.h"
#include "server/solver/hierarchy.h"
#include "server/solver/solver.h"

namespace burnish {

/// Whether this build has the CUDA backend. Without it the functions below fail and say so.
bool cuda_compiled();

/// Name and memory of the device that a backend would use.
/// Fails: failed_precondition: not in this build, no driver, no device.
Result<std::string> cuda_device();

/// Limits what all sessions and meshes together take of the device's memory; without it, all of it.
void set_cuda_memory_budget(uint64_t bytes);
uint64_t cuda_memory_used();  ///< bytes

/// Lets the device do a trifle and waits for it. Fails: internal_error; CUDA's errors stick.
Status probe_cuda_device();

/// The CUDA backend: float32 V-cycle, double outer iteration; on one device the same input gives
/// the same bits. Fails: failed_precondition (no device), unimplemented (smoother),
/// resource_exhausted (device memory, with the numbers).
Result<std::unique_ptr<Backend>> make_cuda_backend(std::shared_ptr<const PreparedMesh> prepared,
                                                   std::shared_ptr<const Hierarchy> hierarchy,
                                                   Smoother smoother);

}  // namespace burnish

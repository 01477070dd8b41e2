#pragma once

#include <cstdint>
#include <string>

#include "common/base/status.h"
#include "server/solver/solver.h"

namespace burnish {

/// Gives the backend's device a trifle to do and waits for it. Processors always work. kAuto asks
/// the CUDA device if there is one. Fails: internal_error in CUDA's words; such an error lasts
/// until the process ends.
Status probe_device(BackendKind backend);

/// Returns whether sessions of this backend may use a device that can fail. Processors are not such
/// a device.
bool has_device(BackendKind backend);

/// Returns the memory of all devices that may share one scan; 0: there is none. `devices`: as in
/// SolverOptions.
uint64_t device_bytes_max(BackendKind backend, int devices);

/// Says where sessions of this backend are solved, and why: "the processors (no CUDA device: this
/// machine has none)". Fails: failed_precondition where kCuda insists on a device that is not
/// there.
Result<std::string> say_where_solved(BackendKind backend);

}  // namespace burnish

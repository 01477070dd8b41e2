#pragma once

#include "common/base/status.h"
#include "server/solver/solver.h"

namespace burnish {

/// Lets the device that the backend uses do a trifle, and waits for it. Processors always work;
/// kAuto asks the CUDA device where there is one. Fails: internal_error in CUDA's words, and from
/// then on for the process's life: such errors stick.
Status probe_device(BackendKind backend);

/// Whether sessions of this backend may be on a device that can fail; the processors are none.
bool has_device(BackendKind backend);

}  // namespace burnish

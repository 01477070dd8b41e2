#pragma once

#include <memory>

#include "common/base/status.h"
#include "common/denoise/surface_filter.h"
#include "server/solver/solver.h"

namespace burnish {

/// Makes the filter of a surface for sessions of this backend: on a device with room for it, else
/// on the processors, which give the same bits. Fails: internal_error if the device has failed.
Result<std::shared_ptr<SurfaceFilter>> make_surface_filter(
    BackendKind backend, std::shared_ptr<const DenoiseSurface> surface);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <memory>

#include "common/base/status.h"
#include "common/denoise/surface_filter.h"

namespace burnish {

/// Returns the bytes of a device that make_cuda_filter() takes. Accuracy: no less than it takes,
/// for meshes whose vertices have six triangles on average.
constexpr uint64_t predict_cuda_filter_bytes(uint64_t triangles, uint64_t vertices) {
  constexpr uint64_t kPerTriangle = 250, kPerVertex = 64;
  return kPerTriangle * triangles + kPerVertex * vertices;
}

/// Makes a filter on the device with the least memory in use. It takes all memory at once, and
/// keeps the surface there. Fails: failed_precondition (no device), resource_exhausted (device
/// memory, with the numbers), internal_error.
Result<std::unique_ptr<SurfaceFilter>> make_cuda_filter(
    std::shared_ptr<const DenoiseSurface> surface);

}  // namespace burnish

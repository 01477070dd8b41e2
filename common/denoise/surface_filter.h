#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/denoise/denoise.h"

namespace burnish {

/// A surface's filtered normals, and the layer of moves towards them.
struct FilteredSurface {
  std::vector<Vec3f> normals;  ///< one per triangle
  std::vector<Vec3f> layer;    ///< one per vertex, at crispness 1; file units
};

/// Filters the normals of one surface and makes their layer, on processors or on a device. All give
/// the same bits. Several threads may call it.
class SurfaceFilter {
 public:
  virtual ~SurfaceFilter() = default;

  /// Fails: as denoise_layer() does; internal_error if a device has failed, from then on.
  virtual Result<FilteredSurface> filter(const EdgeFilter& wanted,
                                         const Progress& progress = {}) = 0;

  /// Returns the bytes that it keeps beside the surface.
  virtual uint64_t byte_count() const = 0;
};

/// Returns the filter of processors. It keeps nothing between calls.
std::unique_ptr<SurfaceFilter> make_processor_filter(std::shared_ptr<const DenoiseSurface> surface);

}  // namespace burnish

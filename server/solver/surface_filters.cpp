#include "server/solver/surface_filters.h"

#include <utility>

#include "server/solver/cuda/cuda_filter.h"
#include "server/solver/device_probe.h"

namespace burnish {

Result<std::shared_ptr<SurfaceFilter>> make_surface_filter(
    BackendKind backend, std::shared_ptr<const DenoiseSurface> surface) {
  if (has_device(backend)) {
    Result<std::unique_ptr<SurfaceFilter>> made = make_cuda_filter(surface);
    if (made.is_ok()) return std::shared_ptr<SurfaceFilter>(std::move(made).value());
    if (made.status().code() != StatusCode::kResourceExhausted) return made.status();
  }
  return std::shared_ptr<SurfaceFilter>(make_processor_filter(std::move(surface)));
}

}  // namespace burnish

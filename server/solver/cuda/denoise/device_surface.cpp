#include "server/solver/cuda/denoise/device_surface.h"

#include <vector>

#include "common/denoise/mean_side.h"

namespace burnish::cuda {

static DeviceArray<uint8_t> surface_mask(Stream& stream, const WeldedSurface& welded) {
  std::vector<uint8_t> mask(welded.triangle_count());
  for (size_t t = 0; t < mask.size(); ++t) mask[t] = welded.is_surface(t);
  return {stream, std::span<const uint8_t>(mask)};
}

DeviceSurface::DeviceSurface(Stream& stream, const DenoiseSurface& surface)
    : ring_start_(stream, {surface.rings.starts(), surface.rings.size() + 1}),
      fan_start_(stream, {surface.welded.fan_starts(), surface.welded.vertex_count() + 1}),
      ring_triangle_(stream, {surface.rings.triangles(), surface.rings.pair_count()}),
      fans_(stream, {surface.welded.fans(), surface.welded.incidence_count()}),
      place_(stream, surface.welded.places()),
      nearness_(stream, surface.rings.pair_count()),
      triangles_(DeviceArray<Corners>::copy_of(stream, surface.welded.triangles())),
      is_surface_(surface_mask(stream, surface.welded)),
      vertices_(DeviceArray<Double3>::copy_of(
          stream, std::span<const Vec3d>(surface.welded.mesh().vertices))),
      unit_(mean_side(surface.welded)) {}

void DeviceSurface::set_nearness(Stream& stream, std::span<const float> nearness) {
  nearness_.upload(stream, nearness);
}

Rings DeviceSurface::rings() const {
  return {static_cast<int64_t>(ring_start_.size()) - 1, ring_start_.data(), ring_triangle_.data(),
          nearness_.data()};
}

Places DeviceSurface::places() const {
  return {static_cast<int64_t>(triangles_.size()),
          static_cast<int64_t>(place_.size()),
          triangles_.data(),
          is_surface_.data(),
          fan_start_.data(),
          fans_.data(),
          place_.data(),
          vertices_.data(),
          unit_};
}

uint64_t DeviceSurface::byte_count() const {
  return ring_start_.byte_count() + fan_start_.byte_count() + ring_triangle_.byte_count() +
         fans_.byte_count() + place_.byte_count() + nearness_.byte_count() +
         triangles_.byte_count() + is_surface_.byte_count() + vertices_.byte_count();
}

}  // namespace burnish::cuda

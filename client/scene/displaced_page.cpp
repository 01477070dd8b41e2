#include "client/scene/displaced_page.h"

namespace burnish {

Vec3d displaced_position(const DisplacedPage& page, size_t vertex) {
  const Vec3f& position = page.mesh.positions[vertex];
  if (page.displacements.empty()) return page.space.to_file(position);
  return page.space.to_file(position, page.displacements[vertex]);
}

static TriangleCorners corners_of(const DisplacedPage& page, uint32_t triangle) {
  TriangleCorners corners;
  for (int i = 0; i < 3; ++i) {
    const uint16_t vertex = page.mesh.triangles[triangle][i];
    corners.original[i] = page.space.to_file(page.mesh.positions[vertex]);
    corners.displaced[i] = displaced_position(page, vertex);
  }
  return corners;
}

std::optional<SurfaceHit> nearest_hit(const DisplacedPage& page, const Ray& ray, uint32_t first,
                                      uint32_t count) {
  std::optional<SurfaceHit> nearest;
  for (uint32_t t = first; t < first + count; ++t) {
    const TriangleCorners corners = corners_of(page, t);
    const auto plane = hit_plane(corners.displaced, ray);
    if (!plane || !is_inside(*plane)) continue;
    if (!nearest || plane->distance < nearest->distance) nearest = make_hit(corners, t, *plane);
  }
  return nearest;
}

}  // namespace burnish

#include "common/mesh/textures/shown_picture.h"

#include <algorithm>
#include <cmath>

namespace burnish {

static bool is_texture_coordinate(double x) {
  return std::abs(x) <= kTextureCoordinateMax;  // false for NaN
}

static Eigen::Vector2d place_on_picture(const SurfaceTextures& textures,
                                        const SurfaceMaterial& material, uint32_t corner) {
  const auto& [u, v] = textures.coordinates[corner];
  return material.to_picture * Eigen::Vector2d(u, v);
}

static bool has_coordinate(const SurfaceTextures& textures, const SurfaceMaterial& material,
                           uint32_t corner) {
  if (corner >= textures.coordinates.size()) return false;
  const auto& [u, v] = textures.coordinates[corner];
  const Eigen::Vector2d place = place_on_picture(textures, material, corner);
  return is_texture_coordinate(u) && is_texture_coordinate(v) && is_texture_coordinate(place.x()) &&
         is_texture_coordinate(place.y());
}

uint32_t shown_picture(const SurfaceTextures& textures, uint32_t triangle) {
  const TexturedTriangle& textured = textures.triangles[triangle];
  if (textured.material == kNoTexture) return kNoTexture;
  const SurfaceMaterial& material = textures.materials[textured.material];
  if (material.picture == kNoTexture) return kNoTexture;
  const bool is_placed = std::ranges::all_of(textured.corners, [&](uint32_t corner) {
    return has_coordinate(textures, material, corner);
  });
  return is_placed ? material.picture : kNoTexture;
}

std::array<Eigen::Vector2d, 3> corners_on_picture(const SurfaceTextures& textures,
                                                  uint32_t triangle) {
  const TexturedTriangle& textured = textures.triangles[triangle];
  const SurfaceMaterial& material = textures.materials[textured.material];
  std::array<Eigen::Vector2d, 3> corners;
  for (size_t k = 0; k < 3; ++k)
    corners[k] = place_on_picture(textures, material, textured.corners[k]);
  return corners;
}

double area_on_picture(const SurfaceTextures& textures, uint32_t triangle) {
  const std::array<Eigen::Vector2d, 3> corners = corners_on_picture(textures, triangle);
  const Eigen::Vector2d a = corners[1] - corners[0];
  const Eigen::Vector2d b = corners[2] - corners[0];
  return std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
}

bool can_be_left_out(const Status& status, const SurfaceTextures& textures) {
  if (status.code() == StatusCode::kUnimplemented) return true;
  return !textures.refuses_damage && status.code() != StatusCode::kCancelled &&
         status.code() != StatusCode::kResourceExhausted;
}

}  // namespace burnish

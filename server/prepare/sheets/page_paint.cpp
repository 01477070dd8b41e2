#include "server/prepare/sheets/page_paint.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/shown_picture.h"
#include "common/mesh/srgb.h"

namespace burnish {

namespace {

double area_of(const std::array<Vec3d, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
}

double area_of(const std::array<Vec2d, 3>& corners) {
  const Vec2d a = corners[1] - corners[0];
  const Vec2d b = corners[2] - corners[0];
  return std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
}

uint8_t byte_of(float value) {
  return static_cast<uint8_t>(std::lround(value));
}

}  // namespace

PagePaint::PagePaint(const Page& page, const TexturedSurface& surface, const PictureTiles& tiles,
                     const TriangleFinder& finder) {
  triangles_.reserve(page.triangles.size());
  for (const PageTriangle& triangle : page.triangles) {
    std::array<Vec3i, 3> places;
    std::array<Vec3d, 3> corners;
    for (int k = 0; k < 3; ++k) {
      places[k] = page.positions[triangle[k]];
      corners[k] = places[k].cast<double>();
    }
    const auto found = finder.find(places);
    if (!found) {
      ++lost_triangles_;
      continue;
    }
    triangles_.push_back(painted(corners, *found, surface, tiles));
    count(triangles_.back());
  }
}

void PagePaint::count(const Painted& painted) {
  if (painted.picture == kNoTexture) return;
  used_texels_ += area_of(painted.on_picture);
  painted_area_ += area_of(painted.places);
}

PagePaint::Painted PagePaint::painted(const std::array<Vec3d, 3>& places,
                                      const FoundTriangle& found, const TexturedSurface& surface,
                                      const PictureTiles& tiles) const {
  const SurfaceTextures& textures = surface.textures;
  Painted painted{.places = places};
  const uint32_t number = textures.triangles[found.triangle].material;
  const SurfaceMaterial material =
      number == kNoTexture ? SurfaceMaterial() : textures.materials[number];
  const uint32_t picture = shown_picture(textures, found.triangle);
  if (picture != kNoTexture && !tiles.place(picture).is_empty()) {
    painted.picture = picture;
    painted.wraps = material.wraps;
    const auto corners = corners_on_picture(textures, found.triangle);
    for (int k = 0; k < 3; ++k)
      painted.on_picture[k] = corners[(k + found.turn) % 3].cwiseProduct(
          Vec2d(tiles.place(picture).width, tiles.place(picture).height));
  }
  painted.tints.fill(painted.picture == kNoTexture ? material.plain : material.factor);
  if (surface.mesh.has_colours())
    for (int k = 0; k < 3; ++k) {
      const uint32_t vertex = surface.mesh.triangles[found.triangle][(k + found.turn) % 3];
      painted.tints[k] = painted.tints[k].cwiseProduct(linear_colour(surface.mesh.colours[vertex]));
    }
  painted.is_tinted =
      std::ranges::any_of(painted.tints, [](const Vec3f& tint) { return tint != Vec3f::Ones(); });
  return painted;
}

Texel PagePaint::texel_of(const Painted& painted, const Vec3d& weights, PictureSampler& sampler) {
  Texel texel = Texel::Constant(255);
  if (painted.picture != kNoTexture) {
    Vec2d at = Vec2d::Zero();
    for (int k = 0; k < 3; ++k) at += weights[k] * painted.on_picture[k];
    texel = sampler.sample(painted.picture, at.x(), at.y(), painted.wraps);
  }
  if (!painted.is_tinted) return texel;
  Vec3f tint = Vec3f::Zero();
  for (int k = 0; k < 3; ++k) tint += static_cast<float>(weights[k]) * painted.tints[k];
  for (int i = 0; i < 3; ++i) texel[i] = srgb_byte(linear_of_srgb(byte_of(texel[i])) * tint[i]);
  return texel;
}

BakeSource PagePaint::source(PictureSampler& sampler) const {
  BakeSource source;
  for (const Painted& painted : triangles_) source.triangles.push_back(painted.places);
  source.texel = [this, &sampler](uint32_t triangle, const Vec3d& weights) {
    return texel_of(triangles_[triangle], weights, sampler);
  };
  return source;
}

}  // namespace burnish

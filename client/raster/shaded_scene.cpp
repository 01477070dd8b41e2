#include "client/raster/shaded_scene.h"

#include <algorithm>

#include "client/raster/shade_math.h"

namespace burnish {

static ShadeVector shade_vector(const Vec3f& from) {
  return {from.x(), from.y(), from.z()};
}

static ShadeVector base_of(LightKind kind) {
  if (kind == LightKind::kCeramic) return shade::kCeramicBase;
  if (kind == LightKind::kBronze) return shade::kBronzeBase;
  if (kind == LightKind::kSlopes) return shade::kSlopesBase;
  return shade::kClayBase;
}

static LightTerms light_terms(const DrawStyle& style) {
  const Lighting& lighting = style.lighting;
  return {.kind = lighting.kind,
          .to_lamp = shade_vector(to_lamp(lighting)),
          .specular = static_cast<float>(lighting.specular),
          .by_ridge = lighting.kind == LightKind::kClay ? 1.0f : 0.0f,
          .turns_back = style.flat ? 0.0f : 1.0f,
          .fading = style.faded ? 1.0f : 0.0f};
}

static std::vector<ShadedRing> shaded_rings(const PageSpace& space, const DrawStyle& style) {
  std::vector<ShadedRing> made;
  for (size_t i = 0; i < std::min(style.rings.size(), kRingsDrawnMax); ++i) {
    const Ring& ring = style.rings[i];
    made.push_back({shade_vector(((ring.centre - space.centre) / space.unit).cast<float>()),
                    static_cast<float>(ring.radius / space.unit),
                    linear(shade_vector(ring.colour))});
  }
  return made;
}

ShadedScene make_shaded_scene(std::span<const RasterPage> pages, const PageSpace& space,
                              const PageProjection& projection, const DrawStyle& style) {
  ShadedScene scene;
  scene.pages = pages;
  scene.projection = projection;
  scene.light = light_terms(style);
  scene.colouring = style.colouring;
  scene.displacement_low = static_cast<float>(style.displacement.low);
  scene.displacement_high = static_cast<float>(style.displacement.high);
  scene.base = base_of(style.lighting.kind);
  scene.tint = linear(shade_vector(style.tint));
  scene.rings = shaded_rings(space, style);
  scene.flat = style.flat;
  scene.wireframe = style.wireframe;
  const int width = projection.size.width;
  scene.first_moved_column = style.original ? width : split_column(style.split, width);
  return scene;
}

}  // namespace burnish

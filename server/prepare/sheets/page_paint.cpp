#include "server/prepare/sheets/page_paint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/check.h"
#include "common/mesh/srgb.h"
#include "common/mesh/textures/shown_picture.h"

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

/// Returns how long a step on the triangle may be on the picture. It is never too little, and too
/// much by a factor of 1.42 at most. Zero without an area.
double stretch_of(const std::array<Vec3d, 3>& places, const std::array<Vec2d, 3>& texels) {
  const Vec3d a = places[1] - places[0];
  const Vec3d b = places[2] - places[0];
  const Vec3d across = b - a * (a.dot(b) / a.squaredNorm());
  Eigen::Matrix2d flat;
  flat << a.norm(), a.dot(b) / a.norm(), 0, across.norm();
  Eigen::Matrix2d shown;
  shown << texels[1] - texels[0], texels[2] - texels[0];
  const double stretch = (shown * flat.inverse()).norm();
  return std::isfinite(stretch) ? stretch : 0;
}

}  // namespace

PagePaint::PagePaint(const Page& page, const TexturedSurface& surface, const PictureTiles& tiles,
                     const TriangleFinder& finder, const LevelledSeams* seams)
    : tiles_(tiles), seams_(seams) {
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
    add(corners, *found, surface);
  }
}

PagePaint::PagePaint(const Page& page, const TexturedSurface& surface, const PictureTiles& tiles,
                     std::span<const uint32_t> triangles)
    : tiles_(tiles), seams_(nullptr) {
  BURNISH_CHECK(triangles.size() == page.triangles.size(), "one triangle of the scan for each");
  triangles_.reserve(triangles.size());
  for (size_t t = 0; t < triangles.size(); ++t) {
    std::array<Vec3d, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = page.positions[page.triangles[t][k]].cast<double>();
    add(corners, {triangles[t], 0}, surface);
  }
}

void PagePaint::add(const std::array<Vec3d, 3>& places, const FoundTriangle& found,
                    const TexturedSurface& surface) {
  triangles_.push_back(painted(places, found, surface));
  count(triangles_.back());
}

void PagePaint::count(const Painted& painted) {
  if (painted.picture == kNoTexture) return;
  const double texels = area_of(texels_of(painted));
  if (texels > 0) shown_.push_back({texels, std::max(area_of(painted.places), kTriangleAreaMin)});
}

double PagePaint::used_texels() const {
  double sum = 0;
  for (const TexelsOnArea& shown : shown_) sum += shown.texels;
  return sum;
}

std::array<Vec2d, 3> PagePaint::texels_of(const Painted& painted) const {
  const TiledLevel& level = tiles_.levels(painted.picture).front();
  std::array<Vec2d, 3> texels = painted.on_picture;
  for (Vec2d& texel : texels) texel = texel.cwiseProduct(Vec2d(level.width, level.height));
  return texels;
}

void PagePaint::put_on_picture(Painted& painted, const FoundTriangle& found, uint32_t picture,
                               const SurfaceTextures& textures) const {
  painted.picture = picture;
  const auto corners = corners_on_picture(textures, found.triangle);
  for (int k = 0; k < 3; ++k) painted.on_picture[k] = corners[(k + found.turn) % 3];
  painted.texels_per_step = stretch_of(painted.places, texels_of(painted));
}

PagePaint::Painted PagePaint::painted(const std::array<Vec3d, 3>& places,
                                      const FoundTriangle& found,
                                      const TexturedSurface& surface) const {
  const SurfaceTextures& textures = surface.textures;
  Painted painted{.places = places};
  const uint32_t number = textures.triangles[found.triangle].material;
  const SurfaceMaterial material =
      number == kNoTexture ? SurfaceMaterial() : textures.materials[number];
  painted.wraps = material.wraps;
  const uint32_t picture = shown_picture(textures, found.triangle);
  if (picture != kNoTexture && tiles_.has(picture))
    put_on_picture(painted, found, picture, textures);
  painted.tints.fill(painted.picture == kNoTexture ? material.plain : material.factor);
  tint(painted, found, surface);
  return painted;
}

/// Multiplies the tints by the colours of the corners, and by the factors of levelled seams.
void PagePaint::tint(Painted& painted, const FoundTriangle& found,
                     const TexturedSurface& surface) const {
  for (int k = 0; k < 3; ++k) {
    const int corner = (k + found.turn) % 3;
    const uint32_t vertex = surface.mesh.triangles[found.triangle][corner];
    if (surface.mesh.has_colours())
      painted.tints[k] = painted.tints[k].cwiseProduct(linear_colour(surface.mesh.colours[vertex]));
    if (seams_ != nullptr)
      painted.tints[k] = painted.tints[k].cwiseProduct(seams_->factor(found.triangle, corner));
  }
  painted.is_tinted =
      std::ranges::any_of(painted.tints, [](const Vec3f& tint) { return tint != Vec3f::Ones(); });
}

Texel PagePaint::texel_of(const Painted& painted, const Drawn& drawn, const Vec3d& weights,
                          PictureSampler& sampler) {
  Texel texel = Texel::Constant(255);
  if (drawn.level != nullptr) {
    Vec2d at = Vec2d::Zero();
    for (int k = 0; k < 3; ++k) at += weights[k] * drawn.corners[k];
    texel = sampler.sample(*drawn.level, at.x(), at.y(), painted.wraps);
  }
  if (!painted.is_tinted) return texel;
  Vec3f tint = Vec3f::Zero();
  for (int k = 0; k < 3; ++k) tint += static_cast<float>(weights[k]) * painted.tints[k];
  for (int i = 0; i < 3; ++i) texel[i] = srgb_byte(linear_of_srgb(byte_of(texel[i])) * tint[i]);
  return texel;
}

/// Takes the finest level that has less than two texels for one of the sheet.
PagePaint::Drawn PagePaint::drawn(const Painted& painted, double texels_per_step) const {
  if (painted.picture == kNoTexture) return {};
  const auto levels = tiles_.levels(painted.picture);
  double texels = painted.texels_per_step / texels_per_step;
  size_t level = 0;
  for (; texels >= 2 && level + 1 < levels.size(); texels /= 2) ++level;
  Drawn drawn{&levels[level], painted.on_picture};
  for (Vec2d& corner : drawn.corners)
    corner = corner.cwiseProduct(Vec2d(levels[level].width, levels[level].height));
  return drawn;
}

BakeSource PagePaint::source(PictureSampler& sampler, double texels_per_step) const {
  BakeSource source;
  std::vector<Drawn> all_drawn;
  for (const Painted& painted : triangles_) {
    source.triangles.push_back(painted.places);
    all_drawn.push_back(drawn(painted, texels_per_step));
  }
  source.texel = [this, &sampler, all_drawn = std::move(all_drawn)](uint32_t triangle,
                                                                    const Vec3d& weights) {
    return texel_of(triangles_[triangle], all_drawn[triangle], weights, sampler);
  };
  return source;
}

}  // namespace burnish

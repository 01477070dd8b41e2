#include "common/mesh/rewrite/pictures/picture_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "common/mesh/textures/shown_picture.h"

namespace burnish {

static const TextureWraps& wraps_of(const SurfaceTextures& textures, uint32_t triangle) {
  return textures.materials[textures.triangles[triangle].material].wraps;
}

static TextureWrap wrap_along(const TextureWraps& wraps, int axis) {
  return axis == 0 ? wraps.u : wraps.v;
}

static std::string repeated(int axis, double least, double most) {
  std::array<char, 128> text;
  std::snprintf(text.data(), text.size(),
                "it repeats: its texture coordinates go from %.4g to %.4g %s", least, most,
                axis == 0 ? "across" : "down");
  return text.data();
}

Result<PicturePlace> PicturePlace::find(const SurfaceTextures& textures,
                                        std::span<const uint32_t> triangles, uint32_t width,
                                        uint32_t height) {
  PicturePlace place(textures, {width, height});
  for (int axis = 0; axis < 2; ++axis) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const uint32_t t : triangles)
      for (const Eigen::Vector2d& corner : corners_on_picture(textures, t)) {
        const bool is_clamped = wrap_along(wraps_of(textures, t), axis) == TextureWrap::kClamp;
        const double at = is_clamped ? std::clamp(corner[axis], 0.0, 1.0) : corner[axis];
        least = std::min(least, at);
        most = std::max(most, at);
      }
    const double tolerance = kRepeatTolerance / place.size_[axis];
    const double repetition = std::floor((least + most) / 2);
    if (least < repetition - tolerance || most > repetition + 1 + tolerance)
      return unimplemented(repeated(axis, least, most));
    place.repetition_[axis] = repetition;
  }
  return place;
}

std::array<Eigen::Vector2d, 3> PicturePlace::corners(uint32_t triangle) const {
  auto corners = corners_on_picture(*textures_, triangle);
  const TextureWraps& wraps = wraps_of(*textures_, triangle);
  for (Eigen::Vector2d& corner : corners)
    for (int axis = 0; axis < 2; ++axis) {
      const TextureWrap wrap = wrap_along(wraps, axis);
      if (wrap != TextureWrap::kClamp) corner[axis] -= repetition_[axis];
      const bool is_turned = wrap == TextureWrap::kMirror && std::fmod(repetition_[axis], 2) != 0;
      corner[axis] = size_[axis] * (is_turned ? 1 - corner[axis] : corner[axis]);
    }
  return corners;
}

}  // namespace burnish

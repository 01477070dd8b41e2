#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "common/base/status.h"
#include "common/mesh/textures/surface_textures.h"

namespace burnish {

/// Texture coordinates may lie so far beyond the picture, in texels, without repeating it.
inline constexpr double kRepeatTolerance = 2;

/// How the triangles of a picture lie on it: all in one repetition.
class PicturePlace {
 public:
  /// `triangles` show this picture of `width` x `height` texels. Fails: unimplemented naming the
  /// coordinates if they repeat the picture. Needs: `textures` outlive this.
  static Result<PicturePlace> find(const SurfaceTextures& textures,
                                   std::span<const uint32_t> triangles, uint32_t width,
                                   uint32_t height);

  /// Returns the corners of a triangle in texels from the top left corner.
  std::array<Eigen::Vector2d, 3> corners(uint32_t triangle) const;

 private:
  PicturePlace(const SurfaceTextures& textures, const Eigen::Vector2d& size)
      : textures_(&textures), size_(size) {}

  const SurfaceTextures* textures_;
  Eigen::Vector2d size_;
  Eigen::Vector2d repetition_ = Eigen::Vector2d::Zero();  // whole numbers
};

}  // namespace burnish

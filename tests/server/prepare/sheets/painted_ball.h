#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/base/types.h"
#include "common/picture/picture.h"

namespace burnish {

/// A bumpy ball around the origin with a smooth pattern on it: six squares of a picture, one for
/// each side of a cube. The pattern follows the direction from the centre, so its colour is known
/// everywhere.
struct PaintedBall {
  int quads_per_side = 30;     ///< 12 quads² triangles
  uint32_t face_texels = 254;  ///< of a side of the cube, without its border of one texel
  double wave = 0.25;          ///< of the pattern, on a ball of radius 1

  Rgba8 colour_at(const Vec3d& position) const;

  Picture picture() const;

  /// Returns an OBJ with a material "skin" of the library "ball.mtl".
  std::string obj() const;

  /// Returns an archive of ball.obj, ball.mtl and skin.png. `png`: the file's bytes.
  std::vector<uint8_t> zip(const std::string& png) const;
  std::vector<uint8_t> zip() const;
};

/// Returns an archive of an OBJ as "ball.obj", ball.mtl and skin.png.
std::vector<uint8_t> zip_of(const std::string& obj, const std::string& png);

/// Returns the bytes of a text.
std::vector<uint8_t> bytes_of(const std::string& text);

}  // namespace burnish

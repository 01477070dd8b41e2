#pragma once

#include <array>
#include <cstdint>

#include "common/base/types.h"
#include "common/picture/picture.h"

namespace burnish {

/// Says how a texture goes on beyond its borders.
enum class TextureWrap { kRepeat, kMirror, kClamp };

/// The wrap along each coordinate.
struct TextureWraps {
  TextureWrap u = TextureWrap::kRepeat;
  TextureWrap v = TextureWrap::kRepeat;
};

/// The two pixels around a coordinate, and the second one's weight.
struct PixelPair {
  uint32_t first = 0;
  uint32_t second = 0;
  double weight = 0;
};

/// The columns and the rows of four pixels.
struct PixelSquare {
  PixelPair x;
  PixelPair y;
};

/// Returns the four pixels between whose centres a texture coordinate lies. (0, 0) is the corner of
/// the first pixel in the top row, (1, 1) that of the last in the bottom row: glTF's convention. An
/// OBJ's v counts from the bottom: pass 1 - v. Coordinates that are not finite count as 0. Needs: a
/// picture with pixels.
PixelSquare pixels_around(double u, double v, uint32_t width, uint32_t height,
                          const TextureWraps& wraps = {});

/// Interpolates between four pixels: the first row's, then the second row's.
Rgba8 mixed_colour(const std::array<Rgba8, 4>& pixels, const PixelSquare& at);

/// Returns the picture's colour at a texture coordinate, of a picture in memory.
Rgba8 sample_texture(const Picture& picture, double u, double v, const TextureWraps& wraps = {});

}  // namespace burnish

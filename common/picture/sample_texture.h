#pragma once

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

/// Returns the picture's colour at a texture coordinate, interpolated between the centres of four
/// pixels. (0, 0) is the corner of the first pixel in the top row, (1, 1) that of the last in the
/// bottom row: glTF's convention. An OBJ's v counts from the bottom: pass 1 - v. Coordinates that
/// are not finite count as 0. Needs: a picture with pixels.
Rgba8 sample_texture(const Picture& picture, double u, double v, const TextureWraps& wraps = {});

}  // namespace burnish

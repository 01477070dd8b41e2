#pragma once

#include "client/scene/page_texture.h"
#include "client/scene/shade_constants.h"

namespace burnish {

/// A place on a texture, or a step over it: texels of its finest level. Texel i has its centre at
/// i + 1/2.
struct TexelPoint {
  float x = 0;
  float y = 0;
};

/// Returns the colour of a texture at a place, filtered as a trilinear sampler does: within each of
/// two levels by weights of 8 bits, and between them. `right` and `down`: how far the place moves
/// to the next pixel. Returns sRGB, 0 to 1.
ShadeVector texel_colour(const PageTexture& texture, TexelPoint place, TexelPoint right,
                         TexelPoint down);

}  // namespace burnish

#pragma once

#include "client/scene/page_texture.h"
#include "client/scene/shade_constants.h"

namespace burnish {

/// A place on a texture, texels of its finest level; texel i has its centre at i + 1/2.
struct TexelPoint {
  float x = 0;
  float y = 0;
};

/// Returns the colour of a texture at a place, filtered as a trilinear sampler does: within each of
/// two levels, and between them. `here`: the place in a pixel; `beside` and `below`: in the pixels
/// to its right and below it. Returns sRGB, 0 to 1.
ShadeVector texel_colour(const PageTexture& texture, TexelPoint here, TexelPoint beside,
                         TexelPoint below);

}  // namespace burnish

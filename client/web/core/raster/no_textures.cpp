#include "client/raster/texel_colour.h"

namespace burnish {

// The page has no sheets, so no texture comes here.
ShadeVector texel_colour(const PageTexture&, TexelPoint, TexelPoint, TexelPoint) {
  return {};
}

}  // namespace burnish

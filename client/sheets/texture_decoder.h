#pragma once

#include "client/sheets/opened_texture.h"

namespace burnish {

/// Decodes charts and a sheet, and checks that they fit the page and the directory. Safe for any
/// bytes.
DecodedTexture decode_texture(const EncodedTexture& encoded, const PageGrid& grid);

}  // namespace burnish

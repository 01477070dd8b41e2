#include "client/sheets/texture_decoder.h"

#include <utility>

#include "common/sheets/webp_texels.h"

namespace burnish {

DecodedTexture decode_texture(const EncodedTexture& encoded, const PageGrid& grid) {
  PageItem damaged;
  Result<OpenedTexture> opened = open_texture(encoded, grid, damaged);
  if (!opened.is_ok()) return {encoded.sheet, nullptr, opened.status(), damaged};
  const SheetLayout& layout = opened->sheet.layout;
  Result<std::vector<Rgba8>> texels =
      decode_webp(opened->webp, layout.width, layout.height, opened->codec);
  return finish_texture(std::move(*opened), std::move(texels), grid);
}

}  // namespace burnish

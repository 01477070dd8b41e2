#include <utility>

#include "client/sheets/texture_decoder.h"
#include "client/surface/desk_thread.h"
#include "client/surface/texture_desk.h"

namespace burnish {

std::unique_ptr<TextureDesk> make_texture_desk(const PageGrid& grid,
                                               std::function<void()> on_news) {
  return std::make_unique<DeskThread<EncodedTexture, DecodedTexture>>(
      [grid](const EncodedTexture& encoded) { return decode_texture(encoded, grid); },
      std::move(on_news));
}

}  // namespace burnish

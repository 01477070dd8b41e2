#pragma once

#include <functional>
#include <memory>

#include "client/sheets/opened_texture.h"
#include "client/surface/desk.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// Checks and decodes sheets.
using TextureDesk = Desk<EncodedTexture, DecodedTexture>;

/// `on_news`: take() has something; called from any thread.
std::unique_ptr<TextureDesk> make_texture_desk(const PageGrid& grid, std::function<void()> on_news);

}  // namespace burnish

#include "client/gl/page_textures.h"

namespace burnish {

// WebGL2 has no buffer textures.
std::unique_ptr<PageTextures> make_page_textures() {
  return nullptr;
}

}  // namespace burnish

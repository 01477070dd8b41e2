#include "client/gl/page_textures.h"
#include "client/gl/shaders.h"

namespace burnish {

// WebGL2 has no buffer textures.
std::unique_ptr<PageTextures> make_page_textures() {
  return nullptr;
}

const char* const kPageTexels = "vec3 surface_colour() { return linear(scan_colour); }\n";

}  // namespace burnish

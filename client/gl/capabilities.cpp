#include "client/gl/capabilities.h"

#include <epoxy/gl.h>

namespace burnish {

// Bytes for indices, half a vertex, and its part of cells and corners; then doubled for all the
// rest.
static constexpr uint64_t kBytesPerTriangle = 200;
static constexpr uint64_t kSoftwareTrianglesMax = 200'000;

Capabilities card_capabilities() {
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (renderer.find("llvmpipe") != std::string::npos)
    return {kSoftwareTrianglesMax, "the picture is drawn without a graphics card"};
  if (!epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) return {};
  GLint free_kilobytes = 0;
  glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &free_kilobytes);
  return {uint64_t(free_kilobytes) * 1024 / kBytesPerTriangle,
          "the graphics card has " + std::to_string(free_kilobytes / 1024) + " MB free"};
}

}  // namespace burnish

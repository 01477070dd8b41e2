#include "client/gl/capabilities.h"

#include <string>

#include <epoxy/gl.h>

namespace burnish {

Capabilities card_capabilities() {
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  for (const char* software : {"llvmpipe", "SwiftShader"})
    if (renderer.find(software) != std::string::npos) return {.is_software = true};
  if (!epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) return {};
  GLint free_kilobytes = 0;
  glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &free_kilobytes);
  return {.free_bytes = uint64_t(free_kilobytes) * 1024};
}

}  // namespace burnish

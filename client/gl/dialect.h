#pragma once

#include <string_view>

#include <epoxy/gl.h>

namespace burnish {

/// Returns whether the current context has OpenGL ES 3.0, as browsers have: WebGL2 is a part of it.
/// Else it has OpenGL 3.3.
inline bool is_embedded() {
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  return std::string_view(version).starts_with("OpenGL ES");
}

}  // namespace burnish

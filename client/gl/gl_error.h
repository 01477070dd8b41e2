#pragma once

#include <string>

#include <epoxy/gl.h>

#include "common/base/status.h"

namespace burnish {

/// Returns OpenGL's error since the last check; `what` is the subject of the message.
inline Status check_gl(const std::string& what) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return Status::ok();
  if (error == GL_OUT_OF_MEMORY)
    return resource_exhausted(what + ": the graphics driver is out of memory");
  return internal_error(what + ": OpenGL error " + std::to_string(error));
}

}  // namespace burnish

#pragma once

#include <algorithm>
#include <string>

#include <epoxy/gl.h>

#include "client/scene/image.h"
#include "common/base/status.h"

namespace burnish {

inline constexpr GLint kSamplesWanted = 4;

/// Returns a limit of the driver of the current context.
inline GLint integer_limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Returns "picture of 640x480 pixels".
inline std::string picture_name(const ImageSize& size) {
  return "picture of " + std::to_string(size.width) + "x" + std::to_string(size.height) + " pixels";
}

/// `limit` is the driver's name of the largest side. Fails: resource_exhausted.
inline Status check_side(const ImageSize& size, GLenum limit) {
  const GLint side_max = integer_limit(limit);
  if (std::max(size.width, size.height) <= side_max) return Status::ok();
  return resource_exhausted(picture_name(size) + ": the graphics driver's limit is " +
                            std::to_string(side_max));
}

}  // namespace burnish

#pragma once

#include <Eigen/Core>
#include <epoxy/gl.h>

#include "client/scene/image.h"
#include "common/base/status.h"

namespace burnish {

/// A picture that OpenGL has not drawn, in the window. Needs: a current context for its whole life.
class ShownImage {
 public:
  ShownImage();
  ~ShownImage();
  ShownImage(const ShownImage&) = delete;
  ShownImage& operator=(const ShownImage&) = delete;

  /// Takes a picture. Fails: resource_exhausted (the driver's limit or memory).
  Status put(const Image& image);

  /// Copies the picture into the window's own buffer, with its lower left corner at this place.
  void show(const Eigen::Vector2i& lower_left) const;

 private:
  ImageSize size_;
  GLuint texture_ = 0;
  GLuint framebuffer_ = 0;
};

/// Clears the window's own buffer to dark and makes it the drawing target.
void clear_window();

}  // namespace burnish

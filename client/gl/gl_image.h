#pragma once

#include "client/scene/image.h"

namespace burnish {

/// A picture as a texture of the current OpenGL context. Needs: the context outlives it.
class GlImage {
 public:
  explicit GlImage(const Image& image);
  ~GlImage();
  GlImage(const GlImage&) = delete;
  GlImage& operator=(const GlImage&) = delete;

  unsigned texture() const { return texture_; }

 private:
  unsigned texture_ = 0;
};

}  // namespace burnish

#include "client/gl/gl_image.h"

#include <epoxy/gl.h>

namespace burnish {

GlImage::GlImage(const Image& image) {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.size.width, image.size.height, 0, GL_RGB,
               GL_UNSIGNED_BYTE, image.rgb.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);  // OpenGL's default
  glBindTexture(GL_TEXTURE_2D, 0);
}

GlImage::~GlImage() {
  glDeleteTextures(1, &texture_);
}

}  // namespace burnish

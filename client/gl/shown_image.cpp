#include "client/gl/shown_image.h"

#include "client/gl/gl_error.h"
#include "client/gl/target_limits.h"

namespace burnish {

ShownImage::ShownImage() {
  glGenTextures(1, &texture_);
  glGenFramebuffers(1, &framebuffer_);
}

ShownImage::~ShownImage() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &texture_);
}

Status ShownImage::put(const Image& image) {
  RETURN_IF_ERROR(check_side(image.size, GL_MAX_TEXTURE_SIZE));
  size_ = image.size;
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, size_.width, size_.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
               image.rgb.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);  // OpenGL's default
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  return check_gl(picture_name(size_));
}

void ShownImage::show(const Eigen::Vector2i& lower_left) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  // Its rows go down, those of OpenGL go up.
  glBlitFramebuffer(0, 0, size_.width, size_.height, lower_left.x(), lower_left.y() + size_.height,
                    lower_left.x() + size_.width, lower_left.y(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void clear_window() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(0.145f, 0.155f, 0.170f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace burnish

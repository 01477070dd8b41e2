#include "client/gl/pick_target.h"

namespace burnish {

PickTarget::PickTarget() {
  glGenFramebuffers(1, &framebuffer_);
  glGenRenderbuffers(1, &number_);
  glGenRenderbuffers(1, &depth_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glBindRenderbuffer(GL_RENDERBUFFER, number_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_R32UI, 1, 1);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, number_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 1, 1);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
}

PickTarget::~PickTarget() {
  glDeleteRenderbuffers(1, &depth_);
  glDeleteRenderbuffers(1, &number_);
  glDeleteFramebuffers(1, &framebuffer_);
}

Status PickTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return resource_exhausted("the graphics driver offers no buffer to pick triangles with");
  glViewport(0, 0, 1, 1);
  const GLuint nothing[4] = {0, 0, 0, 0};
  glClearBufferuiv(GL_COLOR, 0, nothing);
  glClear(GL_DEPTH_BUFFER_BIT);
  return Status::ok();
}

std::optional<uint32_t> PickTarget::read() const {
  GLuint number = 0;
  glReadPixels(0, 0, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &number);
  if (number == 0) return std::nullopt;
  return number - 1;
}

Eigen::Matrix4d pick_matrix(const ImageSize& size, const Eigen::Vector2i& pixel) {
  Eigen::Matrix4d magnify = Eigen::Matrix4d::Identity();
  magnify(0, 0) = size.width;
  magnify(1, 1) = size.height;
  magnify(0, 3) = size.width - 1 - 2 * pixel.x();
  magnify(1, 3) = 2 * pixel.y() + 1 - size.height;
  return magnify;
}

}  // namespace burnish

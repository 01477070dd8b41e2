#include "client/gl/g_buffer_samples.h"

#include <algorithm>
#include <array>

#include "client/gl/target_limits.h"

namespace burnish {

GBufferSamples::GBufferSamples() {
  glGenFramebuffers(1, &framebuffer_);
  for (GLuint* buffer : {&colours_, &geometries_, &depths_}) glGenRenderbuffers(1, buffer);
}

GBufferSamples::~GBufferSamples() {
  for (const GLuint* buffer : {&colours_, &geometries_, &depths_}) glDeleteRenderbuffers(1, buffer);
  glDeleteFramebuffers(1, &framebuffer_);
}

bool GBufferSamples::allocate(const ImageSize& size) const {
  const GLint samples = std::min(kSamplesWanted, integer_limit(GL_MAX_SAMPLES));
  bind();
  const auto attach = [&](GLenum attachment, GLuint buffer, GLenum format) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  };
  attach(GL_COLOR_ATTACHMENT0, colours_, GL_RGBA8);
  attach(GL_COLOR_ATTACHMENT1, geometries_, GL_RGBA16F);
  attach(GL_DEPTH_ATTACHMENT, depths_, GL_DEPTH_COMPONENT24);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void GBufferSamples::clear_cover() const {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void GBufferSamples::resolve(const ImageSize& size, GLuint framebuffer) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  const auto copy = [&](GLenum from, std::array<GLenum, 2> to, GLbitfield what) {
    glReadBuffer(from);
    glDrawBuffers(to.size(), to.data());
    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, what,
                      GL_NEAREST);
  };
  copy(GL_COLOR_ATTACHMENT1, {GL_NONE, GL_COLOR_ATTACHMENT1}, GL_COLOR_BUFFER_BIT);
  copy(GL_COLOR_ATTACHMENT0, {GL_COLOR_ATTACHMENT0, GL_NONE},
       GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace burnish

#pragma once

#include <epoxy/gl.h>

#include "client/scene/image.h"

namespace burnish {

/// Multisampled buffers of a GBufferTarget where textures cannot have samples, which is OpenGL ES
/// 3.0. Needs: a current context for its whole life.
class GBufferSamples {
 public:
  GBufferSamples();
  ~GBufferSamples();
  GBufferSamples(const GBufferSamples&) = delete;
  GBufferSamples& operator=(const GBufferSamples&) = delete;

  /// Leaves the buffers bound for drawing. Returns whether the driver has them.
  bool allocate(const ImageSize& size) const;
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_); }

  /// Makes alpha of the colours 0. The surface has 1. Needs: bind() before.
  void clear_cover() const;

  /// Averages colours and geometries, and takes one of each pixel's depths, into a framebuffer with
  /// the same formats. Leaves that bound.
  void resolve(const ImageSize& size, GLuint framebuffer) const;

 private:
  GLuint framebuffer_ = 0;
  GLuint colours_ = 0;  // renderbuffers
  GLuint geometries_ = 0;
  GLuint depths_ = 0;
};

}  // namespace burnish

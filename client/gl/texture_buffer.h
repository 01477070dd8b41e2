#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <epoxy/gl.h>

#include "common/base/status.h"

namespace burnish {

/// An array on the graphics card that shaders read by index. Needs: a current context for its whole
/// life.
class TextureBuffer {
 public:
  /// `format` is the format of one texel, e.g. GL_RGBA32F with `texel_bytes` 16.
  TextureBuffer(GLenum format, size_t texel_bytes);
  ~TextureBuffer();
  TextureBuffer(const TextureBuffer&) = delete;
  TextureBuffer& operator=(const TextureBuffer&) = delete;

  /// Makes room for `texels` texels, all zero.
  /// Fails: resource_exhausted above the driver's limit of texels or memory; `what` is the subject.
  Status allocate(size_t texels, const std::string& what);

  /// Replaces the texels from `first` on by these bytes. Needs: whole texels inside the buffer.
  void write(size_t first, std::span<const std::byte> bytes) const;

  void bind(int unit) const;
  size_t size() const { return texels_; }

 private:
  GLenum format_;
  size_t texel_bytes_;
  size_t texels_ = 0;
  GLuint buffer_ = 0;
  GLuint texture_ = 0;
};

}  // namespace burnish

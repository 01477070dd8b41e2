#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <epoxy/gl.h>

#include "common/base/status.h"

namespace burnish {

/// A buffer on the graphics card that parts are written to. Needs: a current context for its whole
/// life.
class ArenaBuffer {
 public:
  ArenaBuffer() = default;
  /// Allocates for GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER: browsers want a buffer to be of one
  /// use. `what` is the subject of the message. Fails: resource_exhausted; then OpenGL is as
  /// before, but no vertex array is bound.
  static Result<ArenaBuffer> create(GLenum use, size_t bytes, const std::string& what);
  ArenaBuffer(ArenaBuffer&& other) noexcept;
  ArenaBuffer& operator=(ArenaBuffer&& other) noexcept;
  ~ArenaBuffer();

  /// Needs: a range inside the buffer.
  void write(size_t first_byte, std::span<const std::byte> bytes) const;
  /// Copies the first `bytes` bytes of another buffer.
  void copy_from(const ArenaBuffer& other, size_t bytes) const;
  void bind(GLenum target) const { glBindBuffer(target, buffer_); }

 private:
  explicit ArenaBuffer(GLuint buffer) : buffer_(buffer) {}

  GLuint buffer_ = 0;
};

}  // namespace burnish

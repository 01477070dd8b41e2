#include "client/gl/texture_buffer.h"

#include <vector>

#include "client/gl/gl_error.h"

namespace burnish {

TextureBuffer::TextureBuffer(GLenum format, size_t texel_bytes)
    : format_(format), texel_bytes_(texel_bytes) {
  glGenBuffers(1, &buffer_);
  glGenTextures(1, &texture_);
}

TextureBuffer::~TextureBuffer() {
  glDeleteTextures(1, &texture_);
  glDeleteBuffers(1, &buffer_);
}

Status TextureBuffer::allocate(size_t texels, const std::string& what) {
  GLint texels_max = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels_max);
  if (texels > static_cast<size_t>(texels_max))
    return resource_exhausted(what + " takes " + std::to_string(texels) +
                              " texels, the graphics driver's limit is " +
                              std::to_string(texels_max));
  const std::vector<std::byte> zeros(texels * texel_bytes_);
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(zeros.size()), zeros.data(),
               GL_DYNAMIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, texture_);
  glTexBuffer(GL_TEXTURE_BUFFER, format_, buffer_);
  RETURN_IF_ERROR(check_gl(what));
  texels_ = texels;
  return Status::ok();
}

void TextureBuffer::write(size_t first, std::span<const std::byte> bytes) const {
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_);
  glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * texel_bytes_),
                  static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void TextureBuffer::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, texture_);
}

}  // namespace burnish

#include "client/gl/arena_buffer.h"

#include <utility>

#include "client/gl/gl_error.h"

namespace burnish {

// The first binding decides the use. That of indices belongs to a vertex array.
static void use_first(const ArenaBuffer& buffer, GLenum use) {
  GLuint scratch = 0;
  glGenVertexArrays(1, &scratch);
  glBindVertexArray(scratch);
  buffer.bind(use);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &scratch);
}

Result<ArenaBuffer> ArenaBuffer::create(GLenum use, size_t bytes, const std::string& what) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  ArenaBuffer buffer(name);
  use_first(buffer, use);
  buffer.bind(GL_COPY_WRITE_BUFFER);
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
  RETURN_IF_ERROR(check_gl(what));
  return buffer;
}

ArenaBuffer::ArenaBuffer(ArenaBuffer&& other) noexcept : buffer_(std::exchange(other.buffer_, 0)) {}

ArenaBuffer& ArenaBuffer::operator=(ArenaBuffer&& other) noexcept {
  std::swap(buffer_, other.buffer_);
  return *this;
}

ArenaBuffer::~ArenaBuffer() {
  glDeleteBuffers(1, &buffer_);
}

void ArenaBuffer::write(size_t first_byte, std::span<const std::byte> bytes) const {
  bind(GL_COPY_WRITE_BUFFER);
  glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first_byte),
                  static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

void ArenaBuffer::copy_from(const ArenaBuffer& other, size_t bytes) const {
  other.bind(GL_COPY_READ_BUFFER);
  bind(GL_COPY_WRITE_BUFFER);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                      static_cast<GLsizeiptr>(bytes));
}

}  // namespace burnish

#include "client/gl/edge_lines.h"

#include <algorithm>

namespace burnish {

void EdgeLines::add(std::span<const PageTriangle> triangles, uint32_t first_vertex) {
  for (const PageTriangle& triangle : triangles)
    for (size_t i = 0; i < triangle.size(); ++i) {
      const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % triangle.size()]);
      ends_.push_back(first_vertex + low);
      ends_.push_back(first_vertex + high);
    }
}

Status EdgeLines::upload() {
  const auto bytes = std::as_bytes(std::span(ends_));
  if (bytes.size() > room_bytes_) {
    room_bytes_ = 0;
    const std::string what = "edges of " + std::to_string(ends_.size() / 6) + " triangles";
    ASSIGN_OR_RETURN(buffer_, ArenaBuffer::create(GL_ELEMENT_ARRAY_BUFFER, bytes.size(), what));
    room_bytes_ = bytes.size();
  }
  buffer_.write(0, bytes);
  return Status::ok();
}

void EdgeLines::draw() const {
  buffer_.bind(GL_ELEMENT_ARRAY_BUFFER);
  glDrawElements(GL_LINES, static_cast<GLsizei>(ends_.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace burnish

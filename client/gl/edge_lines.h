#pragma once

#include <cstdint>
#include <vector>

#include "client/gl/arena_buffer.h"
#include "common/pages/page.h"

namespace burnish {

/// The edges of the drawn triangles as lines, for the view of triangles. OpenGL ES has no outlines
/// of triangles. Needs: a current context for its whole life.
class EdgeLines {
 public:
  void clear() { ends_.clear(); }
  /// Adds the edges of triangles, whose vertices begin at first_vertex of the arena. Edges of two
  /// triangles come twice; the depth test drops the second, for both lines have one direction.
  void add(std::span<const PageTriangle> triangles, uint32_t first_vertex);
  /// Fails: resource_exhausted.
  Status upload();
  /// Draws with the current vertex array, whose indices it replaces.
  void draw() const;

 private:
  std::vector<uint32_t> ends_;  // two vertices each
  ArenaBuffer buffer_;
  size_t room_bytes_ = 0;
};

}  // namespace burnish

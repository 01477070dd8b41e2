#pragma once

#include <span>

#include "client/gl/arena_buffer.h"
#include "client/scene/page_renderer.h"

namespace burnish {

/// The numbers of all slots' pages on the graphics card. A slot has room for kPageVerticesMax
/// vertices and kPageTrianglesMax triangles, which is 152 KB. Needs: a current context for its
/// whole life; slots inside the room, pages within the limits.
class PageStreams {
 public:
  PageStreams() = default;
  /// Fails: resource_exhausted.
  static Result<PageStreams> create(uint32_t slots);
  /// Copies the first `slots` slots of other streams.
  void copy_from(const PageStreams& other, uint32_t slots) const;

  /// Writes a page that is not moved and not marked.
  void write_page(uint32_t slot, const PageMesh& mesh) const;
  void write_moves(uint32_t slot, std::span<const Vec3f> displacements,
                   std::span<const Vec3f> normals, std::span<const float> ridges) const;
  void write_marks(uint32_t slot, std::span<const VertexMark> marks) const;
  void write_colours(uint32_t slot, std::span<const Rgba8> colours,
                     std::span<const TexelChange> texels) const;
  void write_triangles(uint32_t slot, std::span<const PageTriangle> triangles) const;

  /// Makes all of it the input of the current vertex array.
  void bind() const;

  /// Makes the triangles' vertices the indices of the current vertex array again.
  void bind_triangles() const { triangles_.bind(GL_ELEMENT_ARRAY_BUFFER); }

  /// Returns where a patch's indices begin, as OpenGL takes it.
  static const void* first_index(const PatchRange& patch);
  static uint32_t first_vertex(uint32_t slot) { return slot * kPageVerticesMax; }

 private:
  ArenaBuffer still_;
  ArenaBuffer moving_;
  ArenaBuffer marked_;
  ArenaBuffer coloured_;   // the displaced surface
  ArenaBuffer texels_;     // likewise
  ArenaBuffer triangles_;  // numbers of vertices in the whole arena: WebGL2 adds no first vertex
};

}  // namespace burnish

#pragma once

#include <span>
#include <vector>

#include <epoxy/gl.h>

#include "client/gl/edge_lines.h"
#include "client/gl/page_streams.h"
#include "client/scene/page_renderer.h"

namespace burnish {

/// The pages on the graphics card. Knows what each slot holds, so that nothing else of a slot is
/// drawn. Needs: a current context for its whole life.
class PageArena {
 public:
  PageArena();
  ~PageArena();
  PageArena(const PageArena&) = delete;
  PageArena& operator=(const PageArena&) = delete;

  void clear() { slots_.assign(slots_.size(), {}); }

  // Work as PageRenderer's functions of these names.
  Status reserve(uint32_t slots);
  Status upload_page(uint32_t slot, const PageMesh& mesh);
  Status move_page(uint32_t slot, std::span<const Vec3f> displacements,
                   std::span<const Vec3f> normals, std::span<const float> ridges);
  Status mark_page(uint32_t slot, std::span<const VertexMark> marks);
  Status colour_page(uint32_t slot, std::span<const Rgba8> colours,
                     std::span<const TexelChange> texels);

  /// Draws the triangles of a page in another order from now on. Shapes: one number per triangle.
  Status order_page(uint32_t slot, std::span<const uint16_t> triangles);

  /// Chooses the patches that draw() draws. Needs: ranges inside the pages of their slots.
  void choose(std::span<const PatchRange> patches);
  void draw() const;
  std::span<const PatchRange> chosen() const { return patches_; }
  /// Draws these triangles, in the order of the page.
  void draw_part(const PatchRange& part) const;

  /// Makes the edges of the chosen patches ready for draw_edges(). Fails: resource_exhausted.
  Status choose_edges();
  void draw_edges() const;

 private:
  struct Slot {
    uint32_t vertices = 0;
    std::vector<PageTriangle> triangles;
  };
  void check_vertices(uint32_t slot, size_t count) const;
  void check_patch(const PatchRange& patch) const;

  GLuint vertex_array_ = 0;
  PageStreams streams_;
  EdgeLines edges_;
  std::vector<Slot> slots_;
  std::vector<PatchRange> patches_;  // the chosen ones; below as OpenGL takes them
  std::vector<GLsizei> index_counts_;
  std::vector<const void*> first_indices_;
};

}  // namespace burnish

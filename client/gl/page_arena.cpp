#include "client/gl/page_arena.h"

#include "client/gl/gl_error.h"
#include "common/base/check.h"

namespace burnish {

PageArena::PageArena() {
  glGenVertexArrays(1, &vertex_array_);
}

PageArena::~PageArena() {
  glDeleteVertexArrays(1, &vertex_array_);
}

Status PageArena::reserve(uint32_t slots) {
  if (slots <= slots_.size()) return Status::ok();
  RETURN_IF_ERROR(check_page_slots(slots));
  ASSIGN_OR_RETURN(PageStreams larger, PageStreams::create(slots));
  if (!slots_.empty()) larger.copy_from(streams_, static_cast<uint32_t>(slots_.size()));
  RETURN_IF_ERROR(check_gl("room for " + std::to_string(slots) + " pages"));
  streams_ = std::move(larger);
  slots_.resize(slots);
  glBindVertexArray(vertex_array_);
  streams_.bind();
  return Status::ok();
}

Status PageArena::upload_page(uint32_t slot, const PageMesh& mesh) {
  const size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  BURNISH_CHECK(vertices <= kPageVerticesMax, "pages are checked where they are decoded");
  BURNISH_CHECK(triangles <= kPageTrianglesMax, "pages are checked where they are decoded");
  slots_[slot] = {};  // nothing half written is drawn
  streams_.write_page(slot, mesh);
  RETURN_IF_ERROR(check_gl("page of " + std::to_string(vertices) + " vertices"));
  slots_[slot] = {static_cast<uint32_t>(vertices), mesh.triangles};
  return Status::ok();
}

void PageArena::check_vertices(uint32_t slot, size_t count) const {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  BURNISH_CHECK(count == slots_[slot].vertices, "one per vertex of the page in the slot");
}

Status PageArena::move_page(uint32_t slot, std::span<const Vec3f> displacements,
                            std::span<const Vec3f> normals, std::span<const float> ridges) {
  check_vertices(slot, displacements.size());
  check_vertices(slot, normals.size());
  check_vertices(slot, ridges.size());
  streams_.write_moves(slot, displacements, normals, ridges);
  return check_gl("displacements of a page");
}

Status PageArena::mark_page(uint32_t slot, std::span<const VertexMark> marks) {
  check_vertices(slot, marks.size());
  streams_.write_marks(slot, marks);
  return check_gl("marks of a page");
}

Status PageArena::colour_page(uint32_t slot, std::span<const Rgba8> colours,
                              std::span<const TexelChange> texels) {
  check_vertices(slot, colours.size());
  check_vertices(slot, texels.size());
  streams_.write_colours(slot, colours, texels);
  return check_gl("colours of a page");
}

Status PageArena::order_page(uint32_t slot, std::span<const uint16_t> triangles) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  const std::vector<PageTriangle>& page = slots_[slot].triangles;
  BURNISH_CHECK(triangles.size() == page.size(), "one number per triangle of the page in the slot");
  std::vector<PageTriangle> ordered;
  ordered.reserve(page.size());
  for (const uint16_t number : triangles) ordered.push_back(page[number]);
  streams_.write_triangles(slot, ordered);
  return check_gl("triangles of a page");
}

void PageArena::check_patch(const PatchRange& patch) const {
  BURNISH_CHECK(patch.slot < slots_.size(), "slots are reserved");
  BURNISH_CHECK(size_t{patch.first} + patch.count <= slots_[patch.slot].triangles.size(),
                "patches lie inside the page in their slot");
}

void PageArena::choose(std::span<const PatchRange> patches) {
  patches_.assign(patches.begin(), patches.end());
  index_counts_.clear();
  first_indices_.clear();
  for (const PatchRange& patch : patches) {
    check_patch(patch);
    index_counts_.push_back(static_cast<GLsizei>(3 * patch.count));
    first_indices_.push_back(PageStreams::first_index(patch));
  }
}

void PageArena::draw() const {
  glBindVertexArray(vertex_array_);
  glMultiDrawElements(GL_TRIANGLES, index_counts_.data(), GL_UNSIGNED_INT, first_indices_.data(),
                      static_cast<GLsizei>(index_counts_.size()));
}

void PageArena::draw_part(const PatchRange& part) const {
  glBindVertexArray(vertex_array_);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * part.count), GL_UNSIGNED_INT,
                 PageStreams::first_index(part));
}

Status PageArena::choose_edges() {
  edges_.clear();
  for (const PatchRange& patch : patches_)
    edges_.add(std::span(slots_[patch.slot].triangles).subspan(patch.first, patch.count),
               PageStreams::first_vertex(patch.slot));
  return edges_.upload();
}

void PageArena::draw_edges() const {
  glBindVertexArray(vertex_array_);
  edges_.draw();
  streams_.bind_triangles();
}

}  // namespace burnish

#include "client/gl/page_streams.h"

#include <vector>

#include "client/gl/page_vertex.h"

namespace burnish {

template <typename Vertex>
static constexpr size_t vertex_bytes(uint32_t slots) {
  return slots * kPageVerticesMax * sizeof(Vertex);
}

// The vertices of a triangle, counted over all slots.
using ArenaTriangle = std::array<uint32_t, 3>;

static constexpr size_t index_bytes(uint32_t slots) {
  return slots * kPageTrianglesMax * sizeof(ArenaTriangle);
}

template <typename Vertex>
static void write(const ArenaBuffer& stream, uint32_t slot, const std::vector<Vertex>& vertices) {
  stream.write(vertex_bytes<Vertex>(slot), std::as_bytes(std::span(vertices)));
}

static Result<ArenaBuffer> create_stream(size_t bytes, const std::string& what) {
  return ArenaBuffer::create(GL_ARRAY_BUFFER, bytes, what);
}

Result<PageStreams> PageStreams::create(uint32_t slots) {
  const std::string what = "room for " + std::to_string(slots) + " pages";
  PageStreams made;
  ASSIGN_OR_RETURN(made.still_, create_stream(vertex_bytes<StillVertex>(slots), what));
  ASSIGN_OR_RETURN(made.moving_, create_stream(vertex_bytes<MovingVertex>(slots), what));
  ASSIGN_OR_RETURN(made.marked_, create_stream(vertex_bytes<MarkedVertex>(slots), what));
  ASSIGN_OR_RETURN(made.coloured_, create_stream(vertex_bytes<Rgba8>(slots), what));
  ASSIGN_OR_RETURN(made.texels_, create_stream(vertex_bytes<TexelVertex>(slots), what));
  ASSIGN_OR_RETURN(made.triangles_,
                   ArenaBuffer::create(GL_ELEMENT_ARRAY_BUFFER, index_bytes(slots), what));
  return made;
}

void PageStreams::copy_from(const PageStreams& other, uint32_t slots) const {
  still_.copy_from(other.still_, vertex_bytes<StillVertex>(slots));
  moving_.copy_from(other.moving_, vertex_bytes<MovingVertex>(slots));
  marked_.copy_from(other.marked_, vertex_bytes<MarkedVertex>(slots));
  coloured_.copy_from(other.coloured_, vertex_bytes<Rgba8>(slots));
  texels_.copy_from(other.texels_, vertex_bytes<TexelVertex>(slots));
  triangles_.copy_from(other.triangles_, index_bytes(slots));
  glFinish();  // NVIDIA's driver 580 lets a write that comes soon after overtake a copy
}

void PageStreams::write_page(uint32_t slot, const PageMesh& mesh) const {
  std::vector<StillVertex> still(mesh.positions.size());
  std::vector<MovingVertex> moving(still.size());
  for (size_t v = 0; v < still.size(); ++v) {
    const PackedShade shade = packed_shade(mesh.normals[v], mesh.ridges[v]);
    still[v] = {mesh.positions[v], shade, mesh.colours.empty() ? Rgba8{} : mesh.colours[v]};
    moving[v] = {Vec3f::Zero(), shade};
  }
  write(still_, slot, still);
  write(moving_, slot, moving);
  write_marks(slot, std::vector<VertexMark>(still.size()));
  write_colours(slot, mesh.colours, std::vector<TexelChange>(still.size()));
  write_triangles(slot, mesh.triangles);
}

void PageStreams::write_triangles(uint32_t slot, std::span<const PageTriangle> triangles) const {
  std::vector<ArenaTriangle> counted(triangles.size());
  for (size_t t = 0; t < counted.size(); ++t)
    for (size_t i = 0; i < 3; ++i) counted[t][i] = first_vertex(slot) + triangles[t][i];
  triangles_.write(index_bytes(slot), std::as_bytes(std::span(counted)));
}

void PageStreams::write_moves(uint32_t slot, std::span<const Vec3f> displacements,
                              std::span<const Vec3f> normals, std::span<const float> ridges) const {
  std::vector<MovingVertex> moving(displacements.size());
  for (size_t v = 0; v < moving.size(); ++v)
    moving[v] = {displacements[v], packed_shade(normals[v], ridges[v])};
  write(moving_, slot, moving);
}

void PageStreams::write_marks(uint32_t slot, std::span<const VertexMark> marks) const {
  write(marked_, slot, std::vector<MarkedVertex>(marks.begin(), marks.end()));
}

void PageStreams::write_colours(uint32_t slot, std::span<const Rgba8> colours,
                                std::span<const TexelChange> texels) const {
  coloured_.write(vertex_bytes<Rgba8>(slot), std::as_bytes(colours));
  std::vector<TexelVertex> changes(texels.size());
  for (size_t v = 0; v < changes.size(); ++v)
    changes[v] << texels[v].light.cast<Eigen::half>(), Eigen::half(texels[v].gain);
  write(texels_, slot, changes);
}

template <typename Vertex>
static void bind_attribute(GLuint index, GLint components, GLenum type, GLboolean normalised,
                           size_t offset) {
  glVertexAttribPointer(index, components, type, normalised, sizeof(Vertex),
                        reinterpret_cast<const void*>(offset));
  glEnableVertexAttribArray(index);
}

template <typename Vertex>
static void bind_integer(GLuint index, GLenum type, size_t offset) {
  glVertexAttribIPointer(index, 1, type, sizeof(Vertex), reinterpret_cast<const void*>(offset));
  glEnableVertexAttribArray(index);
}

void PageStreams::bind() const {
  still_.bind(GL_ARRAY_BUFFER);
  bind_attribute<StillVertex>(0, 3, GL_FLOAT, GL_FALSE, offsetof(StillVertex, position));
  bind_integer<StillVertex>(1, GL_INT, offsetof(StillVertex, shade));
  bind_attribute<StillVertex>(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(StillVertex, colour));
  moving_.bind(GL_ARRAY_BUFFER);
  bind_attribute<MovingVertex>(3, 3, GL_FLOAT, GL_FALSE, offsetof(MovingVertex, displacement));
  bind_integer<MovingVertex>(4, GL_INT, offsetof(MovingVertex, shade));
  marked_.bind(GL_ARRAY_BUFFER);
  bind_attribute<MarkedVertex>(5, 1, GL_BYTE, GL_FALSE, offsetof(VertexMark, value));
  bind_attribute<MarkedVertex>(6, 1, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(VertexMark, tint));
  bind_integer<MarkedVertex>(7, GL_SHORT, offsetof(VertexMark, overlay));
  coloured_.bind(GL_ARRAY_BUFFER);
  bind_attribute<Rgba8>(8, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0);
  texels_.bind(GL_ARRAY_BUFFER);
  bind_attribute<TexelVertex>(9, 4, GL_HALF_FLOAT, GL_FALSE, 0);
  bind_triangles();
}

const void* PageStreams::first_index(const PatchRange& patch) {
  return reinterpret_cast<const void*>(index_bytes(patch.slot) +
                                       patch.first * sizeof(ArenaTriangle));
}

}  // namespace burnish

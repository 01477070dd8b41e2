#include "client/gl/mesh_buffers.h"

#include <limits>
#include <span>

#include "client/gl/gl_error.h"

namespace burnish {

static constexpr size_t kDrawnTrianglesMax = std::numeric_limits<GLsizei>::max() / 3;

template <typename Element>
static void fill(GLenum target, GLuint buffer, const std::vector<Element>& elements) {
  const std::span bytes = std::as_bytes(std::span(elements));
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
}

template <typename Element>
static void fill_attribute(GLuint index, GLint components, GLuint buffer,
                           const std::vector<Element>& values) {
  fill(GL_ARRAY_BUFFER, buffer, values);
  glVertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(index);
}

// Without a grid both attributes are off; the shader never reads their constant value.
static void fill_points(GLuint buffer, const std::vector<EvaluationPoint>& points) {
  if (points.empty()) {
    glDisableVertexAttribArray(3);
    glDisableVertexAttribArray(4);
    return;
  }
  fill(GL_ARRAY_BUFFER, buffer, points);
  const auto* const local = reinterpret_cast<const void*>(offsetof(EvaluationPoint, local));
  glVertexAttribIPointer(3, 1, GL_INT, sizeof(EvaluationPoint), nullptr);
  glVertexAttribPointer(4, 3, GL_FLOAT, GL_FALSE, sizeof(EvaluationPoint), local);
  glEnableVertexAttribArray(3);
  glEnableVertexAttribArray(4);
}

MeshBuffers::MeshBuffers() {
  glGenVertexArrays(1, &vertex_array_);
  glGenBuffers(1, &positions_);
  glGenBuffers(1, &normals_);
  glGenBuffers(1, &ridges_);
  glGenBuffers(1, &points_);
  glGenBuffers(1, &indices_);
}

MeshBuffers::~MeshBuffers() {
  glDeleteBuffers(1, &indices_);
  glDeleteBuffers(1, &points_);
  glDeleteBuffers(1, &ridges_);
  glDeleteBuffers(1, &normals_);
  glDeleteBuffers(1, &positions_);
  glDeleteVertexArrays(1, &vertex_array_);
}

Status MeshBuffers::upload(const ViewMesh& mesh) {
  index_count_ = 0;
  if (mesh.triangles.size() > kDrawnTrianglesMax)
    return resource_exhausted("mesh has " + std::to_string(mesh.triangles.size()) +
                              " triangles, the limit of a picture is " +
                              std::to_string(kDrawnTrianglesMax));
  bind();
  fill_attribute(0, 3, positions_, mesh.positions);
  fill_attribute(1, 3, normals_, mesh.normals);
  fill_attribute(2, 1, ridges_, mesh.ridges);
  fill_points(points_, mesh.points);
  fill(GL_ELEMENT_ARRAY_BUFFER, indices_, mesh.triangles);
  RETURN_IF_ERROR(check_gl("mesh of " + std::to_string(mesh.positions.size()) + " vertices"));
  index_count_ = static_cast<GLsizei>(3 * mesh.triangles.size());
  return Status::ok();
}

void MeshBuffers::draw() const {
  bind();
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace burnish

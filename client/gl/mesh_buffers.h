#pragma once

#include <epoxy/gl.h>

#include "client/scene/view_mesh.h"
#include "common/base/status.h"

namespace burnish {

/// One mesh on the graphics card: positions (attribute 0), normals (1), ridges (2), cells (3) and
/// places in cells (4) if the mesh has a grid, and indices. Needs: a current context for its whole
/// life.
class MeshBuffers {
 public:
  MeshBuffers();
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  /// Fails: resource_exhausted for more triangles than one draw call takes, or when the driver is
  /// out of memory. Then the buffers are empty.
  Status upload(const ViewMesh& mesh);
  void clear() { index_count_ = 0; }
  bool is_empty() const { return index_count_ == 0; }
  void bind() const { glBindVertexArray(vertex_array_); }
  void draw() const;

 private:
  GLuint vertex_array_ = 0;
  GLuint positions_ = 0;
  GLuint normals_ = 0;
  GLuint ridges_ = 0;
  GLuint points_ = 0;
  GLuint indices_ = 0;
  GLsizei index_count_ = 0;
};

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The triangles around each vertex, rising: sums gathered over them are the same for any number
/// of threads. A triangle that repeats a vertex is listed once per corner.
class VertexTriangles {
 public:
  explicit VertexTriangles(const TriangleMesh& mesh);

  std::span<const uint32_t> around(size_t vertex) const {
    return {triangles_.data() + begin_[vertex], triangles_.data() + begin_[vertex + 1]};
  }

 private:
  std::vector<uint64_t> begin_;  // one per vertex, and the end
  std::vector<uint32_t> triangles_;
};

}  // namespace burnish

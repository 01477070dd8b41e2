#pragma once

#include <cstdint>
#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// The triangles around each vertex, rising, so that sums over them do not depend on the number of
/// threads. A triangle that repeats a vertex is there once per corner.
class VertexTriangles {
 public:
  /// Throws: WorkCancelled.
  VertexTriangles(const MeshView& mesh, const ScratchSpace& space,
                  const LoopPart& part = kUnheardLoop);

  std::span<const uint32_t> operator[](size_t vertex) const {
    return {triangles_.data() + start_[vertex], triangles_.data() + start_[vertex + 1]};
  }

 private:
  ScratchArray<uint64_t> start_;
  ScratchArray<uint32_t> triangles_;
};

}  // namespace burnish

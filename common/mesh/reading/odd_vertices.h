#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "common/base/status.h"
#include "common/base/types.h"

namespace burnish {

/// The vertices of a file that have a coordinate which is NaN, infinite or too large. Programs
/// write them for points that a scanner did not see. A file may carry them where no triangle uses
/// them.
class OddVertices {
 public:
  /// Keeps a vertex, and why it is refused if a triangle uses it.
  void keep(uint64_t vertex, const Status& complaint);

  /// Gives the vertices a coordinate of the first triangle in place of each such number, so that
  /// the mesh has none. Fails: with the complaint about the first vertex that a triangle uses.
  /// Needs: indices of triangles are in range.
  Status settle(std::span<Vec3d> vertices, std::span<const Triangle> triangles) const;

 private:
  Status complaint_about(uint64_t vertex) const;

  std::map<uint64_t, Status> complaints_;  // of the first vertices
  bool is_empty_ = true;
};

}  // namespace burnish

#include "common/mesh/reading/odd_vertices.h"

#include <cmath>
#include <string>
#include <vector>

#include "common/mesh/reading/text_values.h"

namespace burnish {

static constexpr size_t kComplaintsMax = 1024;  // a file may have millions

void OddVertices::keep(uint64_t vertex, const Status& complaint) {
  is_empty_ = false;
  if (complaints_.size() < kComplaintsMax) complaints_.try_emplace(vertex, complaint);
}

Status OddVertices::complaint_about(uint64_t vertex) const {
  const auto known = complaints_.find(vertex);
  if (known != complaints_.end()) return known->second;
  return invalid_argument("vertex " + std::to_string(vertex) +
                          ": coordinates must be finite and within ±1e18");
}

static bool is_position(const Vec3d& vertex) {
  return is_coordinate(vertex[0]) && is_coordinate(vertex[1]) && is_coordinate(vertex[2]);
}

Status OddVertices::settle(std::span<Vec3d> vertices, std::span<const Triangle> triangles) const {
  if (is_empty_) return Status::ok();
  std::vector<bool> is_used(vertices.size(), false);
  for (const Triangle& triangle : triangles)
    for (const uint32_t v : triangle) is_used[v] = true;
  for (uint64_t v = 0; v < vertices.size(); ++v)
    if (is_used[v] && !is_position(vertices[v])) return complaint_about(v);
  const Vec3d known = triangles.empty() ? Vec3d(Vec3d::Zero()) : vertices[triangles[0][0]];
  for (Vec3d& vertex : vertices)
    for (int axis = 0; axis < 3; ++axis)
      if (!is_coordinate(vertex[axis])) vertex[axis] = known[axis];
  return Status::ok();
}

}  // namespace burnish

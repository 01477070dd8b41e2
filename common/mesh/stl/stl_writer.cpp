#include <array>

#include <Eigen/Geometry>

#include "common/mesh/output_buffer.h"
#include "common/mesh/stl/stl.h"

namespace burnish {

/// Returns a normal of length 1, or 0 for a triangle without area.
static Vec3f normal_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return (b - a).cross(c - a).stableNormalized().cast<float>();
}

/// Writes positions as floats. STL has no place for colours, shared vertices or doubles.
Status write_stl(const MeshView& mesh, OutputBuffer& output) {
  std::array<char, 80> header = {"Binary STL written by Burnish"};  // must not begin with "solid"
  output.put_bytes(header);
  output.put_bytes(static_cast<uint32_t>(mesh.triangles.size()));
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3d& a = mesh.vertices[triangle[0]];
    const Vec3d& b = mesh.vertices[triangle[1]];
    const Vec3d& c = mesh.vertices[triangle[2]];
    output.put_bytes(normal_of(a, b, c));
    for (const Vec3d* corner : {&a, &b, &c}) {
      const Vec3f position = corner->cast<float>();
      output.put_bytes(position);
    }
    output.put_bytes(uint16_t{0});
  }
  return output.flush();
}

}  // namespace burnish

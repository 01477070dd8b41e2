#pragma once

#include <cmath>
#include <numbers>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Makes a closed sphere around `centre`: two poles on z and `rings` rings of 2·`rings` vertices.
inline TriangleMesh make_test_sphere(const Vec3d& centre, double radius, uint32_t rings = 96) {
  TriangleMesh mesh;
  const uint32_t around = 2 * rings;
  for (uint32_t ring = 1; ring <= rings; ++ring) {
    for (uint32_t step = 0; step < around; ++step) {
      const double polar = std::numbers::pi * ring / (rings + 1);
      const double turn = 2 * std::numbers::pi * step / around;
      mesh.vertices.push_back(centre + radius * Vec3d(std::sin(polar) * std::cos(turn),
                                                      std::sin(polar) * std::sin(turn),
                                                      std::cos(polar)));
    }
  }
  const uint32_t north = rings * around, south = north + 1;
  mesh.vertices.push_back(centre + radius * Vec3d::UnitZ());
  mesh.vertices.push_back(centre - radius * Vec3d::UnitZ());
  for (uint32_t step = 0; step < around; ++step) {
    const uint32_t next = (step + 1) % around;
    mesh.triangles.push_back({north, step, next});
    for (uint32_t row = 0; row + around < north; row += around) {
      mesh.triangles.push_back({row + step, row + around + step, row + next});
      mesh.triangles.push_back({row + next, row + around + step, row + around + next});
    }
    mesh.triangles.push_back({south, north - around + next, north - around + step});
  }
  return mesh;
}

}  // namespace burnish

#pragma once

#include <cstdint>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Gives every triangle vertices of its own.
inline TriangleMesh as_soup(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<uint32_t>(soup.vertices.size());
    for (const uint32_t v : triangle) soup.vertices.push_back(mesh.vertices[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// Gives the triangles beyond x = 0 vertices of their own, as the seam of a texture does.
inline TriangleMesh with_seam(const TriangleMesh& mesh) {
  TriangleMesh seamed = mesh;
  std::vector<uint32_t> beyond(mesh.vertices.size(), 0);  // the copy; 0: none
  for (Triangle& triangle : seamed.triangles) {
    const auto& [a, b, c] = triangle;
    if (mesh.vertices[a].x() + mesh.vertices[b].x() + mesh.vertices[c].x() < 0) continue;
    for (uint32_t& v : triangle) {
      if (beyond[v] == 0) {
        beyond[v] = static_cast<uint32_t>(seamed.vertices.size());
        seamed.vertices.push_back(mesh.vertices[v]);
      }
      v = beyond[v];
    }
  }
  return seamed;
}

}  // namespace burnish

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Returns the mesh beside triangles that are no surface: copies of some triangles or all, either
/// way round, and triangles along every edge whose third vertex is an end, or lies where one does.
inline std::vector<std::pair<std::string, TriangleMesh>> with_triangles_of_no_surface(
    const TriangleMesh& mesh) {
  TriangleMesh some = mesh, all = mesh, turned = mesh, twice = mesh, repeats = mesh, copies = mesh;
  const auto add = [](TriangleMesh& to, uint32_t a, uint32_t b, uint32_t c) {
    to.triangles.push_back({a, b, c});
  };
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (t < 6) add(some, a, b, c);
    for (TriangleMesh* to : {&all, &twice, &twice}) add(*to, b, c, a);
    add(turned, c, b, a);
    for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) {
      add(repeats, from, to, from);
      add(copies, from, to, static_cast<uint32_t>(copies.vertices.size()));
      copies.vertices.push_back(mesh.vertices[from]);
    }
  }
  return {{"some copies", some},      {"copies", all},
          {"turned copies", turned},  {"two copies", twice},
          {"repeated ends", repeats}, {"copied ends", copies}};
}

}  // namespace burnish

#include "tests/server/prepare/pages/pages_test_meshes.h"

#include <random>

#include "common/generate/generate.h"

namespace burnish {

namespace {

Vec3d random_place(std::mt19937& random) {
  Vec3d place;
  for (int axis = 0; axis < 3; ++axis) place[axis] = std::generate_canonical<double, 32>(random);
  return place;
}

}  // namespace

TriangleMesh scan_of_kind(const char* kind, uint64_t vertices) {
  return generate_scan({kind, vertices, 1}).value();
}

TriangleMesh loose_triangles(uint32_t count) {
  std::mt19937 random(1);
  TriangleMesh mesh;
  for (uint32_t t = 0; t < count; ++t) {
    const Vec3d place = random_place(random);
    for (int corner = 0; corner < 3; ++corner)
      mesh.vertices.emplace_back(place + 0.02 * random_place(random));
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

TriangleMesh tangle(uint32_t vertices, uint32_t triangles) {
  std::mt19937 random(1);
  TriangleMesh mesh;
  for (uint32_t v = 0; v < vertices; ++v) mesh.vertices.push_back(random_place(random));
  const auto vertex = [&] { return static_cast<uint32_t>(random() % vertices); };
  while (mesh.triangles.size() < triangles)
    mesh.triangles.push_back({vertex(), vertex(), vertex()});
  return mesh;
}

TriangleMesh with_duplicates(TriangleMesh mesh) {
  const std::vector<Triangle> once = mesh.triangles;
  for (const Triangle& t : once) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  return mesh;
}

TriangleMesh small_components(uint32_t count) {
  std::mt19937 random(1);
  TriangleMesh mesh;
  for (uint32_t small_component = 0; small_component < count; ++small_component) {
    const Vec3d place = random_place(random);
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 4; ++corner)
      mesh.vertices.emplace_back(place + 0.01 * random_place(random));
    for (const Triangle& t : {Triangle{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}})
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return mesh;
}

}  // namespace burnish

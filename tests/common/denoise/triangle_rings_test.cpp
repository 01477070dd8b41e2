#include "common/denoise/triangle_rings.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/common/split_vertices.h"

namespace burnish {
namespace {

using testing::UnorderedElementsAreArray;

bool share_a_place(const Triangle& a, const Triangle& b) {
  for (const uint32_t v : a)
    if (v == b[0] || v == b[1] || v == b[2]) return true;
  return false;
}

std::vector<uint32_t> ring_by_all_pairs(const WeldedSurface& surface, size_t t) {
  std::vector<uint32_t> ring;
  for (uint32_t other = 0; other < surface.triangle_count(); ++other)
    if (other != t && share_a_place(surface.triangle(t), surface.triangle(other)))
      ring.push_back(other);
  return ring;
}

TEST(TriangleRings, AreTheTrianglesThatShareAPlace) {
  for (const char* kind : {"icosphere", "sheet", "fan", "soup", "wall"}) {
    const TriangleMesh mesh = *generate_scan({kind, 500});
    const WeldedSurface surface(mesh);
    const TriangleRings rings(surface);
    ASSERT_EQ(rings.size(), mesh.triangles.size());
    for (size_t t = 0; t < rings.size(); ++t)
      ASSERT_THAT(rings[t], UnorderedElementsAreArray(ring_by_all_pairs(surface, t))) << kind;
  }
}

TEST(TriangleRings, OfASoupAreThoseOfTheMeshInTheSameOrder) {
  const TriangleMesh mesh = make_icosphere(3, 1), soup = as_soup(mesh);
  const WeldedSurface joined(mesh), split(soup);
  const TriangleRings of_mesh(joined), of_soup(split);
  for (size_t t = 0; t < of_mesh.size(); ++t)
    ASSERT_THAT(of_soup[t], testing::ElementsAreArray(of_mesh[t]));
}

/// Triangles around one vertex.
TriangleMesh disc(uint32_t triangles) {
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, 0);
  for (uint32_t i = 0; i < triangles; ++i) {
    const double angle = 2 * M_PI * i / triangles;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % triangles});
  }
  return mesh;
}

TEST(TriangleRings, OfACrowdedPlaceAreTheNeighboursAcrossEdges) {
  const TriangleMesh mesh = disc(100'000);
  const WeldedSurface surface(mesh);
  const TriangleRings rings(surface);
  EXPECT_EQ(rings.pair_count(), 200'000u);
  EXPECT_THAT(rings[7], testing::UnorderedElementsAre(6, 8));
}

TEST(TriangleRings, OfAFullPlaceAreAllThere) {
  const TriangleMesh mesh = disc(kFanTrianglesMax);
  const WeldedSurface surface(mesh);
  EXPECT_EQ(TriangleRings(surface)[7].size(), kFanTrianglesMax - 1);
}

TEST(TriangleRings, HearACancel) {
  const TriangleMesh mesh = make_icosphere(1, 1);
  const WeldedSurface surface(mesh);
  const Progress cancel = [](std::string_view, double) { return false; };
  EXPECT_THROW(TriangleRings(surface, {}, {cancel, "rings"}), WorkCancelled);
}

}  // namespace
}  // namespace burnish

#include "common/denoise/welded_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/common/odd_triangles.h"
#include "tests/common/split_vertices.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

TEST(WeldedSurface, VerticesAtOnePlaceHaveTheFanOfTheLeast) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const WeldedSurface surface(mesh);
  EXPECT_EQ(surface.place(3), 1u);
  EXPECT_EQ(surface.triangle(1), (Triangle{1, 4, 2}));
  EXPECT_THAT(surface.fan(1), ElementsAre(0, 1));
  EXPECT_THAT(surface.fan(3), IsEmpty());
}

TEST(WeldedSurface, ASoupHasTheFansOfTheMesh) {
  const TriangleMesh mesh = make_icosphere(2, 1), soup = as_soup(mesh);
  const WeldedSurface joined(mesh), split(soup);
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      EXPECT_THAT(split.fan(split.triangle(t)[corner]),
                  ElementsAreArray(joined.fan(joined.triangle(t)[corner])));
}

TEST(WeldedSurface, TrianglesOfNoSurfaceAreAtNoPlace) {
  const TriangleMesh mesh = make_icosphere(1, 1);
  for (const auto& [name, odd] : with_triangles_of_no_surface(mesh)) {
    const WeldedSurface surface(odd);
    for (size_t t = 0; t < odd.triangles.size(); ++t)
      EXPECT_EQ(surface.is_surface(t), t < mesh.triangles.size()) << name;
    for (size_t v = 0; v < mesh.vertices.size(); ++v)
      EXPECT_THAT(surface.fan(v), testing::Each(testing::Lt(mesh.triangles.size()))) << name;
  }
}

TEST(WeldedSurface, HearsACancel) {
  const TriangleMesh mesh = make_icosphere(1, 1);
  const Progress cancel = [](std::string_view, double) { return false; };
  EXPECT_THROW(WeldedSurface(mesh, {}, {cancel, "rings"}), WorkCancelled);
}

}  // namespace
}  // namespace burnish

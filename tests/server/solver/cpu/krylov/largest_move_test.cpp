#include "server/solver/cpu/krylov/largest_move.h"

#include <random>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

std::vector<Float4> random_directions(int32_t corners) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> number(-1, 1);
  std::vector<Float4> p(corners);
  for (Float4& of : p) of = {number(random), number(random), number(random), 0};
  return p;
}

TEST(LargestMove, IsThatOfTheFarthestVertex) {
  for (const auto& mesh : {generate_scan({.kind = "tablet", .vertices = 20000}).value(),
                           reference::several_components()}) {
    const TestSystem system(mesh, 6);
    const SparseGrid& grid = system.hierarchy->at(6).grid;
    const std::vector<Float4> p = random_directions(grid.corner_count());
    const Float4 a = {0.5, 2, -3, 0};
    double farthest = 0;
    for (const EvaluationPoint& point : system.prepared->evaluation) {
      const Float4 along = evaluate<Float4>(grid, point, p);
      farthest = std::max<double>(farthest, (a * along).matrix().norm());
    }
    ASSERT_GT(farthest, 1);
    EXPECT_NEAR(largest_move(grid, system.hierarchy->points, p, a), farthest, 1e-5 * farthest);
  }
}

TEST(LargestMove, PassesOverVerticesWithoutACell) {
  TriangleMesh mesh = reference::bumpy_sphere(3);
  const size_t referenced = mesh.vertices.size();
  mesh.vertices.emplace_back(0.5, 0, 0);
  const TestSystem system(mesh, 5);
  ASSERT_EQ(system.prepared->evaluation.size(), referenced + 1);
  EXPECT_EQ(system.hierarchy->points.item.size(), referenced);
}

}  // namespace
}  // namespace burnish::cpu

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "common/mesh/statistics/components.h"
#include "server/prepare/prepare.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"

namespace burnish {
namespace {

std::shared_ptr<const PreparedMesh> prepared_at(const TriangleMesh& mesh, int depth) {
  PrepareOptions options;
  options.depth = depth;
  return *prepare(mesh, options);
}

// A sphere, and a small component that lies partly in the sphere's cells.
TriangleMesh sphere_with_a_small_component() {
  const TriangleMesh sphere = reference::bumpy_sphere(4);
  const auto beside = [&](Vec3d p) { return Vec3d(1.05 * sphere.vertices[0] + 0.03 * p); };
  return reference::joined(sphere, reference::mapped(reference::bumpy_sphere(1), beside));
}

TEST(CellSheets, OneComponentHasNone) {
  EXPECT_TRUE(prepared_at(reference::bumpy_sphere(4), 5)->sheets.empty());
  EXPECT_TRUE(prepared_at(reference::non_manifold_fan(20), 5)->sheets.empty());
}

TEST(CellSheets, ASoupHasNone) {
  const auto soup = prepared_at(reference::shaken_soup(reference::bumpy_sphere(4), 0.01), 5);
  EXPECT_TRUE(soup->sheets.empty());
}

TEST(CellSheets, ASmallComponentAndWhatItFloatsOverHaveOneEachInTheCellsThatTheyShare) {
  const TriangleMesh mesh = sphere_with_a_small_component();
  const auto prepared = prepared_at(mesh, 5);
  const std::vector<int32_t> roots = component_roots(mesh.triangles, mesh.vertices.size());
  std::set<std::pair<int32_t, uint32_t>> listed;
  for (const CellSheet& sheet : prepared->sheets) listed.insert({sheet.cell, sheet.component});
  EXPECT_EQ(listed.size(), prepared->sheets.size());
  ASSERT_GE(listed.size(), 2u);
  EXPECT_EQ(listed.size() % 2, 0u);
  for (const auto& [cell, component] : listed) {
    const auto small = static_cast<uint32_t>(roots.back());
    EXPECT_TRUE(component == 0 || component == small);
    EXPECT_TRUE(listed.contains({cell, component == 0 ? small : 0}));
  }
}

TEST(CellSheets, TheirIntegralsAddUpToTheCells) {
  const auto prepared = prepared_at(sphere_with_a_small_component(), 5);
  ASSERT_FALSE(prepared->sheets.empty());
  for (size_t s = 0; s < prepared->sheets.size(); s += 2) {
    const CellIntegrals &first = prepared->sheet_integrals[s],
                        &second = prepared->sheet_integrals[s + 1];
    ASSERT_EQ(prepared->sheets[s].cell, prepared->sheets[s + 1].cell);
    const CellIntegrals& whole = prepared->integrals[prepared->sheets[s].cell];
    for (int p = 0; p < 28; ++p) {
      EXPECT_NEAR(first.mass[p] + second.mass[p], whole.mass[p], 1e-14);
      for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(first.stiffness[i][p] + second.stiffness[i][p], whole.stiffness[i][p], 1e-13);
    }
  }
}

TEST(CellSheets, TheirPassagesAreTheirCells) {
  const auto prepared = prepared_at(sphere_with_a_small_component(), 5);
  ASSERT_FALSE(prepared->sheets.empty());
  for (size_t s = 0; s < prepared->sheets.size(); s += 2)
    EXPECT_EQ(prepared->sheets[s].passages | prepared->sheets[s + 1].passages,
              prepared->passages[prepared->sheets[s].cell]);
}

}  // namespace
}  // namespace burnish

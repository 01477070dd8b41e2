#include "server/prepare/passages.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/server/prepare/test_meshes.h"

namespace burnish {
namespace {

using Corners = std::array<Vec3d, 3>;
using Prepared = std::shared_ptr<const PreparedMesh>;

constexpr int kDepth = 5;
constexpr double kCell = 1 / 0.9 / 32;  // at that depth, of a mesh of width 1

Prepared prepared_at(int depth, const TriangleMesh& mesh) {
  return prepare(mesh, {.depth = depth}).value();
}

TriangleMesh generated(const char* kind) {
  return generate_scan({.kind = kind, .vertices = 4000}).value();
}

bool has(Passages passages, int slot) {
  return (passages >> slot & 1) != 0;
}

// Returns the index of the cell at a slot of another; -1 for none.
ptrdiff_t neighbour(const PreparedMesh& mesh, size_t cell, int slot) {
  const MortonKey key = morton_key(morton_point(mesh.cells[cell]) + offset_of_slot(slot));
  const auto at = std::ranges::lower_bound(mesh.cells, key);
  return at != mesh.cells.end() && *at == key ? at - mesh.cells.begin() : -1;
}

void expect_symmetric(const PreparedMesh& mesh) {
  ASSERT_EQ(mesh.passages.size(), mesh.cells.size());
  for (size_t c = 0; c < mesh.cells.size(); ++c) {
    ASSERT_EQ(mesh.passages[c] & ~kAllPassages, 0u);
    for (int slot = 0; slot < kSlots; ++slot) {
      if (!has(mesh.passages[c], slot)) continue;
      const ptrdiff_t other = neighbour(mesh, c, slot);
      ASSERT_GE(other, 0) << "cell " << c << " has a passage to no cell at slot " << slot;
      ASSERT_TRUE(has(mesh.passages[other], opposite_slot(slot))) << "cell " << c;
    }
  }
}

// Returns how many parts the cells form if one walks through passages.
size_t part_count(const PreparedMesh& mesh) {
  std::vector<size_t> parent(mesh.cells.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](size_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  for (size_t c = 0; c < mesh.cells.size(); ++c)
    for (int slot = 0; slot < kSlots; ++slot)
      if (has(mesh.passages[c], slot)) parent[root(c)] = root(neighbour(mesh, c, slot));
  size_t parts = 0;
  for (size_t c = 0; c < parent.size(); ++c) parts += parent[c] == c;
  return parts;
}

// A flat sheet over [from, to] × [-1/2, 1/2], in cells of a mesh of width 1.
TriangleMesh flat_sheet(double from, double to, double z, int side = 7) {
  return test_patch(
      side, [=](double u, double v) { return Vec3d(from + u * (to - from), v - 0.5, z * kCell); });
}

// Checks that no passage leaves a layer of cells, and that within it each cell leads to all its
// neighbours.
void expect_passages_in_layers(const PreparedMesh& mesh) {
  for (size_t c = 0; c < mesh.cells.size(); ++c)
    for (int slot = 0; slot < kSlots; ++slot) {
      const Vec3i offset = offset_of_slot(slot);
      if (offset.z() != 0) {
        ASSERT_FALSE(has(mesh.passages[c], slot)) << "cell " << c << " slot " << slot;
      } else if (offset.squaredNorm() == 1) {
        ASSERT_EQ(has(mesh.passages[c], slot), neighbour(mesh, c, slot) >= 0) << "cell " << c;
      }
    }
}

// Checks all cells of a triangle, and the passages from each to all others beside it.
void expect_passages_between_all_cells(const Corners& triangle) {
  std::vector<CellColumn> columns;
  find_columns(triangle, columns);
  std::set<MortonKey> cells;
  for (const auto& [i, j, range] : columns)
    for (int k = range.first; k <= range.last; ++k) cells.insert(morton_key({i, j, k}));
  size_t visited = 0;
  for_each_cell_with_passages(triangle, columns, [&](const Vec3i& cell, Passages passages) {
    ++visited;
    ASSERT_TRUE(cells.contains(morton_key(cell)));
    Passages expected = 0;
    for (int slot = 0; slot < kSlots; ++slot)
      if (cells.contains(morton_key(cell + offset_of_slot(slot)))) expected |= Passages{1} << slot;
    ASSERT_EQ(passages, expected & kAllPassages);
  });
  EXPECT_EQ(visited, cells.size());
}

TEST(TrianglePassages, LeadFromEachOfItsCellsToAllOthersBesideIt) {
  std::mt19937 random(3);
  const auto next = [&](double size) { return 9 + size * (random() / 4294967296.0 - 0.5); };
  for (double size : {0.01, 0.7, 3.0, 8.0, 16.0})
    for (int i = 0; i < 100; ++i) {
      Corners triangle;
      for (Vec3d& p : triangle) p = Vec3d(next(size), next(size), next(size));
      expect_passages_between_all_cells(triangle);
    }
}

TEST(TrianglePassages, OfATriangleOverTensOfThousandsOfCellsAreTheSame) {
  expect_passages_between_all_cells(
      {Vec3d(1.3, 1.2, 1.1), Vec3d(200.7, 1.4, 90.2), Vec3d(2.1, 250.6, 130.9)});
  expect_passages_between_all_cells(  // the columns of one row, and one column
      {Vec3d(1.3, 1.2, 1.1), Vec3d(1.7, 900.4, 1.2), Vec3d(1.4, 1.6, 900.9)});
}

TEST(TrianglePassages, AcrossAGridPlaneThatItsEdgeLiesInAreInDoubt) {
  const Corners triangle = {Vec3d(2, 0.2, 0.5), Vec3d(2, 0.8, 0.5), Vec3d(1.4, 0.5, 0.6)};
  std::vector<CellColumn> columns;
  find_columns(triangle, columns);
  for_each_cell_with_passages(triangle, columns, [](const Vec3i& cell, Passages passages) {
    EXPECT_EQ(cell, Vec3i(1, 0, 0));
    EXPECT_EQ(passages, Passages{1} << slot_of_offset(1, 0, 0) | Passages{1} << kSlots);
  });
}

TEST(OneSidedPassages, AreClosedWhereInDoubt) {
  const std::vector<MortonKey> cells = {morton_key({4, 4, 4}), morton_key({5, 4, 4}),
                                        morton_key({6, 4, 4})};
  const Passages up = Passages{1} << slot_of_offset(1, 0, 0);
  const Passages down = Passages{1} << slot_of_offset(-1, 0, 0);
  std::vector<Passages> passages = {up | kInDoubt, up | down, up | kInDoubt};
  close_one_sided_passages(cells, passages, {});
  EXPECT_EQ(passages, (std::vector<Passages>{up, up | down, 0}));
}

TEST(OneSidedPassages, DoNotLeadToACellThatGoes) {
  std::vector<MortonKey> cells = {morton_key({4, 4, 4}), morton_key({5, 4, 4}),
                                  morton_key({6, 4, 4})};
  const Passages up = Passages{1} << slot_of_offset(1, 0, 0);
  const Passages down = Passages{1} << slot_of_offset(-1, 0, 0);
  std::vector<Passages> passages = {up, up | down, down};
  doubt_passages_to(2, cells, passages);
  cells.pop_back();
  passages.pop_back();
  close_one_sided_passages(cells, passages, {});
  EXPECT_EQ(passages, (std::vector<Passages>{up, down}));
}

TEST(Passages, OfASheetLeadAlongIt) {
  expect_passages_in_layers(*prepared_at(kDepth, flat_sheet(-0.5, 0.5, 0)));
}

TEST(Passages, OfASheetOfTwoTrianglesOverThousandsOfCellsLeadAlongIt) {
  const Prepared mesh = prepared_at(7, flat_sheet(-0.5, 0.5, 0, 1));
  EXPECT_GT(mesh->cells.size(), 10'000u);
  expect_passages_in_layers(*mesh);
}

TEST(Passages, DoNotLeadFromASheetToOneACellAway) {
  const Prepared mesh = prepared_at(
      kDepth, reference::joined(flat_sheet(-0.5, 0.5, -0.5), flat_sheet(-0.5, 0.5, 0.5)));
  const int below = slot_of_offset(0, 0, -1), above = slot_of_offset(0, 0, 1);
  for (size_t c = 0; c < mesh->cells.size(); ++c)
    ASSERT_TRUE(neighbour(*mesh, c, below) >= 0 || neighbour(*mesh, c, above) >= 0);
  expect_passages_in_layers(*mesh);
  EXPECT_EQ(part_count(*mesh), 2u);
}

TEST(Passages, DoNotLeadFromASheetInAGridPlaneToOneInTheNext) {
  const TriangleMesh outer = reference::joined(flat_sheet(-0.5, 0.5, -1), flat_sheet(-0.5, 0.5, 1));
  const Prepared mesh = prepared_at(kDepth, reference::joined(outer, flat_sheet(-0.5, 0.5, 0)));
  expect_passages_in_layers(*mesh);
  EXPECT_EQ(part_count(*mesh), 3u);
}

TEST(Passages, DoNotLeadAcrossAGridPlaneToASheetThatEndsBeforeIt) {
  const auto parts_with_gap = [](double gap) {
    return part_count(*prepared_at(
        kDepth, reference::joined(flat_sheet(-0.5, 0, 0), flat_sheet(gap * kCell, 0.5, 0))));
  };
  EXPECT_EQ(parts_with_gap(0.3), 2u);
  EXPECT_EQ(parts_with_gap(0), 1u);
}

TEST(Passages, LeadFromAFaceInAGridPlaneToWallsThatStandAgainstIt) {
  const auto wall = [](double x, double from, double to) {
    return test_patch(
        5, [=](double u, double v) { return Vec3d(x, u - 0.5, (from + v * (to - from)) * kCell); });
  };
  const TriangleMesh walls = reference::joined(wall(-0.21, -4, 0), wall(0.13, 0, 4));
  EXPECT_EQ(part_count(*prepared_at(kDepth, reference::joined(flat_sheet(-0.5, 0.5, 0), walls))),
            1u);
}

TEST(Passages, HoldTogetherWhatTheMiddleOfTheBoxCutsAtEdges) {
  for (const char* kind : {"icosphere", "cylinder", "sheet", "fan", "part"}) {
    SCOPED_TRACE(kind);
    EXPECT_EQ(part_count(*prepared_at(6, generated(kind))), 1u);
  }
  EXPECT_EQ(part_count(*prepared_at(kDepth, reference::stepped_block(2))), 1u);
}

TEST(Passages, KeepPartsThatAreFarFromEachOtherApart) {
  EXPECT_EQ(part_count(*prepared_at(kDepth, reference::several_components())), 4u);
}

TEST(Passages, LeadBothWaysAndToCellsOnly) {
  for (const char* kind : {"blob", "fan", "soup", "sheets", "part"}) {
    SCOPED_TRACE(kind);
    expect_symmetric(*prepared_at(6, generated(kind)));
  }
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    expect_symmetric(*prepared_at(kDepth, mesh));
  }
}

}  // namespace
}  // namespace burnish

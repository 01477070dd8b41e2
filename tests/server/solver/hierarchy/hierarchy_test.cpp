#include "server/solver/hierarchy/hierarchy.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/grid/stencil_slots.h"
#include "server/prepare/prepare.h"
#include "server/solver/hierarchy/cell_matrix.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

struct Sample {
  std::shared_ptr<const PreparedMesh> prepared;
  std::shared_ptr<const Hierarchy> apart, together;
};

// Spheres, some of which touch, and two sheets a small part of a cell apart.
const Sample& sample() {
  static const Sample made = [] {
    const TestSystem system(
        reference::joined(reference::several_components(), reference::two_near_sheets(40, 0.04)),
        6);
    return Sample{system.prepared, system.hierarchy,
                  make_hierarchy(*system.prepared, Sheets::kTogether)};
  }();
  return made;
}

using NeighbourSets = std::vector<std::set<int32_t>>;

void add_tied(const SparseGrid& grid, const CellTie& tie, NeighbourSets& neighbours) {
  for (int v = 0; v < kCornersPerCell; ++v)
    for (int w = 0; w < kCornersPerCell; ++w) {
      if ((tie.first_corners >> v & tie.second_corners >> w & 1) == 0) continue;
      const int32_t first = grid.cell_corners[tie.first][v];
      const int32_t second = grid.cell_corners[tie.second][w];
      if (first == second) continue;
      neighbours[first].insert(second);
      neighbours[second].insert(first);
    }
}

class HierarchyTest : public testing::TestWithParam<Sheets> {
 protected:
  const Hierarchy& hierarchy() const {
    return GetParam() == Sheets::kApart ? *sample().apart : *sample().together;
  }
  template <typename Check>
  void for_each_transfer(Check&& check) const {
    for (int depth = hierarchy().finest; depth > hierarchy().coarsest; --depth)
      check(hierarchy().at(depth), hierarchy().at(depth - 1));
  }
  /// Returns 0 for corners that follow a small component's anchor, or nothing, and 1 for the
  /// others.
  Eigen::VectorXd beyond_small_components(const HierarchyDepth& fine) const {
    Eigen::VectorXd is_beyond = Eigen::VectorXd::Ones(fine.grid.corner_count());
    if (fine.is_finest())
      for (const int32_t corner : hierarchy().small_components.corner) is_beyond[corner] = 0;
    return is_beyond;
  }
};

INSTANTIATE_TEST_SUITE_P(All, HierarchyTest, testing::Values(Sheets::kApart, Sheets::kTogether),
                         [](const auto& sheets) {
                           return sheets.param == Sheets::kApart ? "SheetsApart" : "SheetsTogether";
                         });

Sparse restriction_matrix(const DepthTransfer& transfer, int32_t fine_corners) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto coarse_corners = static_cast<int32_t>(transfer.restriction_start.size() - 1);
  for (int32_t i = 0; i < coarse_corners; ++i)
    for (int64_t k = transfer.restriction_start[i]; k < transfer.restriction_start[i + 1]; ++k)
      entries.emplace_back(i, transfer.restriction_corner[k], transfer.restriction_weight[k]);
  Sparse matrix(coarse_corners, fine_corners);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST_P(HierarchyTest, EndsWhereADirectSolveIsCheap) {
  EXPECT_EQ(hierarchy().finest, 6);
  EXPECT_LT(hierarchy().coarsest, 6);
  EXPECT_EQ(static_cast<int>(hierarchy().depths.size()),
            hierarchy().finest - hierarchy().coarsest + 1);
  for (int depth = hierarchy().coarsest; depth <= hierarchy().finest; ++depth) {
    const SparseGrid& grid = hierarchy().at(depth).grid;
    EXPECT_EQ(grid.depth, depth);
    const bool cheap = grid.corner_count() <= kCoarsestCornersMax || depth == kCoarsestDepthMin;
    EXPECT_EQ(cheap, depth == hierarchy().coarsest);
  }
}

TEST_P(HierarchyTest, ProlongationIsAPartitionOfUnity) {
  for_each_transfer([&](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    const Sparse p = prolongation_matrix(fine, coarse);
    const Eigen::VectorXd sums = p * Eigen::VectorXd::Ones(p.cols());
    const Eigen::VectorXd errors =
        (sums.array() - 1).matrix().cwiseProduct(beyond_small_components(fine));
    EXPECT_LT(errors.cwiseAbs().maxCoeff(), 1e-6);
  });
}

TEST_P(HierarchyTest, ProlongationReproducesPositions) {
  const auto positions = [](const SparseGrid& grid, double scale) {
    Eigen::MatrixXd rows(grid.corner_count(), 3);
    for (int32_t i = 0; i < grid.corner_count(); ++i)
      rows.row(i) = scale * morton_point(grid.corners[i].place).cast<double>().transpose();
    return rows;
  };
  for_each_transfer([&](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    const Eigen::MatrixXd prolonged = prolongation_matrix(fine, coarse) * positions(coarse.grid, 2);
    const Eigen::MatrixXd errors =
        beyond_small_components(fine).asDiagonal() * (prolonged - positions(fine.grid, 1));
    EXPECT_LT(errors.cwiseAbs().maxCoeff(), 1e-5);
  });
}

TEST_P(HierarchyTest, RestrictionIsTheTransposeOfProlongation) {
  for_each_transfer([](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    const Sparse p = prolongation_matrix(fine, coarse);
    const Sparse r = restriction_matrix(fine.to_parent, fine.grid.corner_count());
    ASSERT_EQ(r.rows(), p.cols());
    EXPECT_EQ((r - Sparse(p.transpose())).norm(), 0);
  });
}

TEST_P(HierarchyTest, CellsAreChildrenOfTheirParentOrApart) {
  for_each_transfer([](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    std::vector<int> seen(fine.grid.cells.size());
    for (int32_t parent = 0; parent < coarse.grid.cell_count(); ++parent) {
      ASSERT_LE(coarse.children[parent].size(), 8u);
      for (const int32_t child : coarse.children[parent]) {
        ASSERT_EQ(fine.parent_cell[child], parent);
        ++seen[child];
      }
    }
    for (int32_t cell : coarse.shares.apart) ++seen[cell];
    ASSERT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
  });
}

TEST_P(HierarchyTest, ParentsLieAboveTheirChildren) {
  for_each_transfer([](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    for (int32_t cell = 0; cell < fine.grid.cell_count(); ++cell) {
      const int32_t parent = fine.parent_cell[cell];
      if (parent == kNone) continue;  // in a small component
      ASSERT_EQ(coarse.grid.cells[parent].place, fine.grid.cells[cell].place >> 3);
    }
  });
}

TEST(Hierarchy, SmallComponentsHaveNoCoarseCellsAndFollowWhatTheyHangOn) {
  const TestSystem system(reference::small_components_over_a_sphere(), 6);
  const HierarchyDepth& finest = system.hierarchy->depths.back();
  EXPECT_GT(system.hierarchy->small_components.count(), 20);
  EXPECT_EQ(system.plan->patches.corner_sets(), system.hierarchy->small_components.corner_sets());
  EXPECT_GT(std::ranges::count(finest.parent_cell, kNone), 100);
  const Sparse p = prolongation_matrix(finest, system.hierarchy->at(5));
  const Eigen::VectorXd sums = p * Eigen::VectorXd::Ones(p.cols());
  int floating = 0;
  for (const double sum : sums) {
    if (sum == 0)
      ++floating;
    else
      ASSERT_NEAR(sum, 1, 1e-6);
  }
  EXPECT_GT(floating, 0);
  EXPECT_LT(floating, sums.size() / 10);
}

// Each of the wall's pieces would have eight corners there.
TEST(Hierarchy, OfATornWallHasASmallCoarsestDepth) {
  const auto prepared =
      prepare(generate_scan({.kind = "wall", .vertices = 30'000}).value(), {.depth = 6}).value();
  EXPECT_LT(make_hierarchy(*prepared)->depths.front().grid.corner_count(), kCoarsestCornersMax);
}

TEST(Hierarchy, PiecesOfSurfaceHaveTheirOwnCornersWhenSheetsAreTogether) {
  const Hierarchy& together = *sample().together;
  for (int depth = together.finest; depth > together.coarsest; --depth) {
    const HierarchyDepth &fine = together.at(depth), &coarse = together.at(depth - 1);
    for (int32_t i = 0; i < fine.grid.corner_count(); ++i)
      ASSERT_EQ(coarse.grid.cells[fine.to_parent.prolongation[i].cell].component,
                fine.grid.corners[i].component);
    EXPECT_TRUE(coarse.ties.empty());
    EXPECT_TRUE(coarse.stencil.irregular.corner.empty());
  }
}

TEST(Hierarchy, SheetsThatMeetInCornersAreTiedWhenTheyAreApart) {
  const Hierarchy& apart = *sample().apart;
  EXPECT_GT(apart.at(apart.finest).to_parent.shared.count(), 0);
  EXPECT_FALSE(apart.at(apart.finest - 1).ties.empty());
  EXPECT_TRUE(apart.at(apart.finest).stencil.irregular.corner.empty());
}

// The two sheets are some cells apart at the finest depth and lie in one coarse cell.
TEST(Hierarchy, SheetsInOneCoarseCellHaveACornerEach) {
  const TestSystem system(reference::two_near_sheets(40, 0.2), 5);
  const SparseGrid& coarsest = system.hierarchy->depths.front().grid;
  std::map<MortonKey, int> corners;
  for (const GridKey& corner : coarsest.corners) ++corners[corner.place];
  EXPECT_TRUE(std::ranges::any_of(corners, [](const auto& entry) { return entry.second >= 2; }));
}

TEST(Hierarchy, LooseCellsHaveNeitherTiesNorIrregularRows) {
  TriangleMesh confetti;
  for (int i = 0; i < 4096; ++i) {
    const Vec3d at = morton_point(static_cast<MortonKey>(i)).cast<double>() * 1.1;
    const auto first = static_cast<uint32_t>(confetti.vertices.size());
    for (const Vec3d& corner : {Vec3d(0, 0, 0), Vec3d(0.1, 0, 0.05), Vec3d(0, 0.1, 0)})
      confetti.vertices.push_back(at + corner);
    confetti.triangles.push_back({first, first + 1, first + 2});
  }
  const TestSystem system(confetti, 5);
  for (const HierarchyDepth& depth : system.hierarchy->depths) {
    EXPECT_TRUE(depth.stencil.irregular.corner.empty());
    EXPECT_TRUE(depth.ties.empty());
  }
}

TEST_P(HierarchyTest, RowsHoldEveryCornerThatSharesACellOrATie) {
  for (const HierarchyDepth& depth : hierarchy().depths) {
    NeighbourSets neighbours(depth.grid.corners.size());
    for (const auto& corners : depth.grid.cell_corners)
      for (int32_t a : corners)
        for (int32_t b : corners)
          if (a != b) neighbours[a].insert(b);
    for (const CellTie& tie : depth.ties) add_tied(depth.grid, tie, neighbours);
    const Stencil& stencil = depth.stencil;
    for (int32_t i = 0; i < depth.grid.corner_count(); ++i) {
      const auto begin = stencil.column.begin() + stencil.row(i).begin;
      const auto end = stencil.column.begin() + stencil.row(i).end;
      ASSERT_EQ(std::set<int32_t>(begin, end), neighbours[i]);
      ASSERT_EQ(static_cast<size_t>(end - begin), neighbours[i].size());
    }
  }
}

TEST_P(HierarchyTest, RowsOfAWindowAreStoredByRisingLength) {
  for (const HierarchyDepth& depth : hierarchy().depths) {
    const Stencil& stencil = depth.stencil;
    const int32_t n = depth.grid.corner_count();
    for (int32_t row = 0; row < n; ++row) {
      const int32_t corner = stencil.corner_of_row[row];
      ASSERT_EQ(stencil.row_of_corner[corner], row);
      ASSERT_EQ(corner / Stencil::kRowWindow, row / Stencil::kRowWindow);
      if (row % Stencil::kRowWindow == 0) continue;
      const auto before = stencil.row(stencil.corner_of_row[row - 1]), here = stencil.row(corner);
      ASSERT_LE(before.end - before.begin, here.end - here.begin);
    }
  }
}

TEST_P(HierarchyTest, RowsArePaddedWithTheirOwnCorner) {
  for (const HierarchyDepth& depth : hierarchy().depths) {
    const Stencil& stencil = depth.stencil;
    for (int32_t row = 0; row < depth.grid.corner_count(); ++row) {
      const int32_t corner = stencil.corner_of_row[row];
      ASSERT_EQ(stencil.row_start[row + 1] % Stencil::kRowPadding, 0);
      for (int64_t k = stencil.row(corner).end; k < stencil.row_start[row + 1]; ++k)
        ASSERT_EQ(stencil.column[k], corner);
    }
  }
}

TEST_P(HierarchyTest, RegularRowsFindANeighbourByItsSlot) {
  for (const HierarchyDepth& depth : hierarchy().depths)
    for (const auto& corners : depth.grid.cell_corners)
      for (int a = 0; a < kCornersPerCell; ++a)
        for (int b = 0; b < kCornersPerCell; ++b) {
          if (a == b || depth.stencil.is_irregular(corners[a])) continue;
          const int64_t k = depth.stencil.position(corners[a], slot_between(a, b));
          ASSERT_EQ(depth.stencil.column[k], corners[b]);
        }
}

TEST_P(HierarchyTest, CellsWithAnIrregularCornerKnowTheirEntries) {
  for (const HierarchyDepth& depth : hierarchy().depths) {
    const Stencil& stencil = depth.stencil;
    size_t next = 0;
    for (int32_t cell = 0; cell < depth.grid.cell_count(); ++cell) {
      const auto& corners = depth.grid.cell_corners[cell];
      const auto is_irregular = [&](int32_t corner) { return stencil.is_irregular(corner); };
      if (std::ranges::none_of(corners, is_irregular)) continue;
      ASSERT_LT(next, stencil.irregular_cells.cell.size());
      ASSERT_EQ(stencil.irregular_cells.cell[next], cell);
      const auto& entry = stencil.irregular_cells.entry[next++];
      for (int a = 0; a < kCornersPerCell; ++a)
        for (int b = a + 1; b < kCornersPerCell; ++b)
          ASSERT_EQ(stencil.column[stencil.row(corners[a]).begin + entry[pair_index(a, b)]],
                    corners[b]);
    }
    EXPECT_EQ(next, stencil.irregular_cells.cell.size());
  }
}

TEST(Hierarchy, ConnectingCellsCanBeCancelledFromTheFirstReportToTheLast) {
  const TestSystem system(reference::two_near_sheets(40, 0.04), 6);
  int reports = 0;
  ASSERT_TRUE(make_hierarchy(*system.prepared, [&](std::string_view, double) {
                return ++reports > 0;
              }).is_ok());
  EXPECT_GT(reports, 2);
  for (const int last : {0, 1, reports / 2, reports - 1}) {
    int seen = 0;
    const auto stopped =
        make_hierarchy(*system.prepared, [&](std::string_view, double) { return seen++ < last; });
    EXPECT_EQ(stopped.status().code(), StatusCode::kCancelled);
  }
}

}  // namespace
}  // namespace burnish

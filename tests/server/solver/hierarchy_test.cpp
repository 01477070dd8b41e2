#include "server/solver/hierarchy.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

const Hierarchy& sample() {
  static const TestSystem system(reference::several_components(), 6);
  return *system.hierarchy;
}

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

template <typename Check>
void for_each_transfer(Check&& check) {
  for (int depth = sample().finest; depth > sample().coarsest; --depth)
    check(sample().at(depth), sample().at(depth - 1));
}

TEST(Hierarchy, EndsWhereADirectSolveIsCheap) {
  EXPECT_EQ(sample().finest, 6);
  EXPECT_LT(sample().coarsest, 6);
  EXPECT_EQ(static_cast<int>(sample().depths.size()), sample().finest - sample().coarsest + 1);
  for (int depth = sample().coarsest; depth <= sample().finest; ++depth) {
    const SparseGrid& grid = sample().at(depth).grid;
    EXPECT_EQ(grid.depth, depth);
    const bool cheap = grid.corner_count() <= kCoarsestCornersMax || depth == kCoarsestDepthMin;
    EXPECT_EQ(cheap, depth == sample().coarsest);
  }
}

TEST(Hierarchy, ProlongationIsAPartitionOfUnity) {
  for_each_transfer([](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    const Sparse p = prolongation_matrix(fine, coarse);
    EXPECT_EQ(p * Eigen::VectorXd::Ones(p.cols()), Eigen::VectorXd::Ones(p.rows()));
  });
}

TEST(Hierarchy, ProlongationReproducesPositions) {
  const auto positions = [](const SparseGrid& grid, double scale) {
    Eigen::MatrixXd rows(grid.corner_count(), 3);
    for (int32_t i = 0; i < grid.corner_count(); ++i)
      rows.row(i) = scale * morton_point(grid.corners[i].place).cast<double>().transpose();
    return rows;
  };
  for_each_transfer([&](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    const Eigen::MatrixXd prolonged = prolongation_matrix(fine, coarse) * positions(coarse.grid, 2);
    EXPECT_EQ(prolonged, positions(fine.grid, 1));
  });
}

TEST(Hierarchy, RestrictionIsTheTransposeOfProlongation) {
  for_each_transfer([](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    const Sparse p = prolongation_matrix(fine, coarse);
    const Sparse r = restriction_matrix(fine.to_parent, fine.grid.corner_count());
    ASSERT_EQ(r.rows(), p.cols());
    EXPECT_EQ((r - Sparse(p.transpose())).norm(), 0);
  });
}

TEST(Hierarchy, PiecesOfSurfaceNeverMeetInACorner) {
  for_each_transfer([](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    for (int32_t i = 0; i < fine.grid.corner_count(); ++i)
      ASSERT_EQ(coarse.grid.cells[fine.to_parent.prolongation[i].cell].component,
                fine.grid.corners[i].component);
  });
}

TEST(Hierarchy, ChildrenAreTheCellsThatNameTheirParent) {
  for_each_transfer([](const HierarchyDepth& fine, const HierarchyDepth& coarse) {
    ASSERT_EQ(coarse.child.size(), fine.grid.cells.size());
    for (int32_t parent = 0; parent < coarse.grid.cell_count(); ++parent) {
      ASSERT_LT(coarse.child_start[parent], coarse.child_start[parent + 1]);
      for (int32_t k = coarse.child_start[parent]; k < coarse.child_start[parent + 1]; ++k)
        ASSERT_EQ(fine.parent_cell[coarse.child[k]], parent);
    }
  });
}

TEST(Stencil, HoldsEveryCornerThatSharesACellAndNoOther) {
  for (const HierarchyDepth& depth : sample().depths) {
    std::vector<std::set<int32_t>> neighbours(depth.grid.corners.size());
    for (const auto& corners : depth.grid.cell_corners)
      for (int32_t a : corners)
        for (int32_t b : corners)
          if (a != b) neighbours[a].insert(b);
    const Stencil& stencil = depth.stencil;
    for (int32_t i = 0; i < depth.grid.corner_count(); ++i) {
      const auto begin = stencil.column.begin() + stencil.row(i).begin;
      const auto end = stencil.column.begin() + stencil.row(i).end;
      ASSERT_EQ(std::set<int32_t>(begin, end), neighbours[i]);
      ASSERT_EQ(static_cast<size_t>(end - begin), neighbours[i].size());
    }
  }
}

TEST(Stencil, StoresTheRowsOfAWindowByRisingLength) {
  for (const HierarchyDepth& depth : sample().depths) {
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

TEST(Stencil, PadsARowWithItsOwnCorner) {
  for (const HierarchyDepth& depth : sample().depths) {
    const Stencil& stencil = depth.stencil;
    for (int32_t row = 0; row < depth.grid.corner_count(); ++row) {
      const int32_t corner = stencil.corner_of_row[row];
      ASSERT_EQ(stencil.row_start[row + 1] % Stencil::kRowPadding, 0);
      for (int64_t k = stencil.row(corner).end; k < stencil.row_start[row + 1]; ++k)
        ASSERT_EQ(stencil.column[k], corner);
    }
  }
}

TEST(Stencil, FindsANeighbourByItsSlot) {
  for (const HierarchyDepth& depth : sample().depths)
    for (const auto& corners : depth.grid.cell_corners)
      for (int a = 0; a < kCornersPerCell; ++a)
        for (int b = 0; b < kCornersPerCell; ++b) {
          if (a == b) continue;
          const int64_t k = depth.stencil.position(corners[a], slot_between(a, b));
          ASSERT_EQ(depth.stencil.column[k], corners[b]);
        }
}

}  // namespace
}  // namespace burnish

#include "client/report/depth_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/grid/depth_plan.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

MeshStatistics tablet_of_large_edges() {
  MeshStatistics scan;
  scan.box_max = {90, 90, 9};  // 100 mm for 2^depth cells
  scan.area = 2 * 90 * 90;
  scan.mean_edge_length = 0.26;  // 1.5 of them are a cell of depth 8
  return scan;
}

TEST(DepthText, MemoryHasTwoDigitsOrItsWholeUnits) {
  EXPECT_EQ(memory_text(1.84e9), "1.8 GB");
  EXPECT_EQ(memory_text(14e9), "14 GB");
  EXPECT_EQ(memory_text(123.4e9), "123 GB");
  EXPECT_EQ(memory_text(456e6), "456 MB");
  EXPECT_EQ(memory_text(45e6), "45 MB");
}

TEST(DepthText, ACoarseDepthTellsTheDepthThatMatchesTheEdges) {
  const MeshStatistics scan = tablet_of_large_edges();
  const double more = plan_depth(scan, 8).memory_bytes - plan_depth(scan, 6).memory_bytes;
  EXPECT_THAT(edges_text(scan, "mm", 6),
              AllOf(HasSubstr("0.26 mm"), HasSubstr("depth 8"), HasSubstr(memory_text(more))));
}

TEST(DepthText, ADepthThatMatchesTheEdgesHasNoOtherBesideIt) {
  for (const int depth : {8, 9})
    EXPECT_EQ(edges_text(tablet_of_large_edges(), "mm", depth), "the scan's own edges are 0.26 mm");
}

}  // namespace
}  // namespace burnish

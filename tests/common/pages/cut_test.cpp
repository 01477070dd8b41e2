#include "common/pages/cut.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/pages/legal_cut.h"

namespace burnish {
namespace {

using testing::ElementsAre;

/// Returns two fine pages, two of the next level that both replace both, and a root.
PageDirectory diamond() {
  PageDirectory directory;
  directory.head.level_pages = {2, 2, 1};
  directory.entries.resize(5);
  const std::vector<std::vector<PageId>> coarser = {{2, 3}, {2, 3}, {4}, {4}, {}};
  for (const auto& list : coarser) directory.coarser.add(list);
  return directory;
}

TEST(Cut, TheEmptySetIsLegal) {
  EXPECT_TRUE(is_legal_cut(diamond(), PageSet(5, 0)));
}

TEST(Cut, ASetThatLacksACoarserPageIsNotLegal) {
  EXPECT_FALSE(is_legal_cut(diamond(), PageSet{1, 0, 1, 0, 1}));
  EXPECT_FALSE(is_legal_cut(diamond(), PageSet{0, 0, 1, 0, 0}));
  EXPECT_TRUE(is_legal_cut(diamond(), PageSet{1, 0, 1, 1, 1}));
}

TEST(Cut, ClosingASetAddsItsCoarserPagesOnly) {
  PageSet set = {0, 1, 0, 0, 0};
  close_cut(diamond(), set);
  EXPECT_THAT(set, ElementsAre(0, 1, 1, 1, 1));
}

TEST(Cut, APatchIsDrawnUnlessItsFinerPageIsInTheSet) {
  const PageSet set = {1, 0, 1, 1, 1};
  EXPECT_FALSE(is_drawn({.finer = 0, .triangles = 1}, set));
  EXPECT_TRUE(is_drawn({.finer = 1, .triangles = 1}, set));
  EXPECT_TRUE(is_drawn({.finer = kNoPage, .triangles = 1}, set));
}

}  // namespace
}  // namespace burnish

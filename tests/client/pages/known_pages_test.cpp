#include "client/pages/known_pages.h"

#include <gtest/gtest.h>

#include "tests/client/pages/ready_pages.h"

namespace burnish {
namespace {

TEST(KnownPages, EveryPageIsInItsBlock) {
  const SyntheticScan scan = make_synthetic_scan();
  const KnownPages known(scan.directory.head);
  for (PageId page = 0; page < scan.directory.entries.size(); ++page)
    ASSERT_EQ(known.block_of(page), scan.directory.head.block_of(page)) << page;
}

TEST(KnownPages, LevelZeroHasTheFirstBlocks) {
  const SyntheticScan scan = make_synthetic_scan();
  const KnownPages known(scan.directory.head);
  const PageId pages = scan.directory.head.level_pages[0];
  EXPECT_EQ(known.pages_of(known.level_zero_blocks() - 1).end, pages);
}

TEST(KnownPages, PagesAreKnownWhenTheirBlockHasCome) {
  const SyntheticScan scan = make_synthetic_scan();
  KnownPages known(scan.directory.head);
  EXPECT_EQ(known.find(300), nullptr);
  known.add(1, scan.block(1));
  ASSERT_NE(known.find(300), nullptr);
  EXPECT_EQ(*known.find(300), scan.directory.entries[300]);
  EXPECT_EQ(known.find(255), nullptr);
  EXPECT_EQ(known.known_blocks(), 1u);
  known.forget(1);
  EXPECT_EQ(known.find(300), nullptr);
  EXPECT_EQ(known.known_blocks(), 0u);
}

TEST(KnownPages, BlocksNameTheBlocksOfTheirCoarserPages) {
  const SyntheticScan scan = make_synthetic_scan();
  const KnownPages known = know_all(scan);
  for (uint32_t block = 0; block < known.block_count(); ++block) {
    const auto& coarser = known.find_block(block)->coarser_blocks;
    EXPECT_TRUE(std::ranges::is_sorted(coarser));
    for (const PageId page : known.find_block(block)->directory.coarser.item)
      ASSERT_TRUE(std::ranges::binary_search(coarser, known.block_of(page)));
  }
}

}  // namespace
}  // namespace burnish

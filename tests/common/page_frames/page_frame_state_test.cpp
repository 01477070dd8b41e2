#include "common/page_frames/page_frame_state.h"

#include <gtest/gtest.h>

#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

/// A page and its values.
using Size = std::pair<PageId, uint32_t>;

ShownPages showing(const std::vector<Size>& sizes) {
  PageChange change{.revision = 1};
  for (const auto& [page, values] : sizes) change.added.push_back(plain_page(page, values));
  return ShownPages().changed(change);
}

PageFrameState filled(const ShownPages& shown, int32_t value) {
  PageFrameState state = start_page_frame(shown, {});
  for (PageTile& tile : state.tiles)
    tile.narrowed =
        std::make_shared<const NarrowValues>(std::vector<int32_t>(tile.value_count(), value));
  return state;
}

std::vector<int32_t> values(const PageTile& tile) {
  std::vector<int32_t> read(tile.value_count(), 99);
  tile.read(read);
  return read;
}

TEST(PageFrameState, APageThatTheReferenceDoesNotShowBeginsWithZero) {
  const PageFrameState reference = filled(showing({{2, 1}, {5, 2}}), 7);
  const PageFrameState state = start_page_frame(showing({{1, 1}, {5, 2}, {9, 1}}), reference);
  ASSERT_EQ(state.tiles.size(), 3u);
  EXPECT_EQ(values(state.tiles[0]), std::vector<int32_t>(3, 0));
  EXPECT_EQ(values(state.tiles[1]), std::vector<int32_t>(6, 7));
  EXPECT_EQ(values(state.tiles[2]), std::vector<int32_t>(3, 0));
}

TEST(PageFrameState, APageOfAnotherSizeIsAnotherPage) {
  const PageFrameState reference = filled(showing({{2, 3}}), 7);
  EXPECT_EQ(start_page_frame(showing({{2, 4}}), reference).tiles[0].narrowed, nullptr);
}

TEST(PageFrameState, TakesTheGainOfTheReference) {
  PageFrameState reference = filled(showing({{2, 1}}), 7);
  reference.tiles[0].gain = 3;
  const PageFrameState state = start_page_frame(showing({{2, 1}, {3, 1}}), reference);
  EXPECT_EQ(state.tiles[0].gain, 3);
  EXPECT_EQ(state.tiles[1].gain, 0);
}

TEST(PageFrameState, FindsAPageByItsNumber) {
  const PageFrameState state = filled(showing({{2, 1}, {5, 2}}), 7);
  EXPECT_EQ(state.find(5), &state.tiles[1]);
  EXPECT_EQ(state.find(4), nullptr);
  EXPECT_EQ(state.find(6), nullptr);
}

TEST(PageFrameState, SharesTheValuesOfItsReference) {
  const ShownPages shown = showing({{2, 100}});
  const PageFrameState reference = filled(shown, 7);
  EXPECT_EQ(start_page_frame(shown, reference).tiles[0].narrowed, reference.tiles[0].narrowed);
}

TEST(PageFrameState, StaysWithinItsLimitWhileDisplacementsAreSmall) {
  const ShownPages shown = showing({{2, 100}, {3, 2048}});
  EXPECT_LE(filled(shown, -32768).byte_count(), page_state_bytes_max(shown.pages()));
  EXPECT_GT(filled(shown, -32769).byte_count(), page_state_bytes_max(shown.pages()));
}

TEST(PageFrameState, DisplacementsAreInCells) {
  PageTile tile = {.shown = plain_page(4, 2)};
  tile.narrowed =
      std::make_shared<const NarrowValues>(std::vector<int32_t>{128, 0, -64, 0, 1, 256});
  std::vector<Vec3f> displacements(2);
  tile.read_displacements(displacements);
  EXPECT_EQ(displacements[0], Vec3f(0.5F, -0.25F, 1 / 256.F));
  EXPECT_EQ(displacements[1], Vec3f(0, 0, 1));
}

}  // namespace
}  // namespace burnish

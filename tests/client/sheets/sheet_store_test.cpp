#include "client/sheets/sheet_store.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr uint64_t kTextureBytes = (64 + 16 + 4) * 4;

std::shared_ptr<const PageTexture> texture() {
  auto made = std::make_shared<PageTexture>();
  made->levels = texture_levels(8, 8, std::vector<Rgba8>(64));
  return made;
}

TEST(SheetStore, TheLongestUnusedGoesFirst) {
  SheetStore store(2 * kTextureBytes + 10);
  for (const PageId page : {1U, 2U, 3U}) {
    store.begin_picture();
    store.use(page);
    if (page == 3) store.use(1);
    ASSERT_TRUE(store.hold_texture(page, 0, texture()));
  }
  EXPECT_EQ(store.find(2), nullptr);
  EXPECT_NE(store.find(1), nullptr);
  EXPECT_NE(store.find(3), nullptr);
  EXPECT_EQ(store.bytes(), 2 * kTextureBytes);
}

TEST(SheetStore, NothingOfTheCurrentPictureGoes) {
  SheetStore store(2 * kTextureBytes);
  store.begin_picture();
  for (const PageId page : {1U, 2U, 3U}) store.use(page);
  EXPECT_TRUE(store.hold_texture(1, 0, texture()));
  EXPECT_TRUE(store.hold_texture(2, 0, texture()));
  EXPECT_FALSE(store.hold_texture(3, 0, texture()));
  EXPECT_EQ(store.use(3).texture, nullptr);
  EXPECT_LE(store.bytes(), store.budget());
}

TEST(SheetStore, ADecodedSheetTakesThePlaceOfItsBytes) {
  SheetStore store(10'000);
  store.begin_picture();
  store.use(7);
  ASSERT_TRUE(store.hold_charts(7, std::vector<uint8_t>(100)));
  ASSERT_TRUE(store.hold_sheet(7, 2, std::vector<uint8_t>(1000)));
  EXPECT_EQ(store.bytes(), 1100u);
  const uint64_t before = store.changes();
  ASSERT_TRUE(store.hold_texture(7, 2, texture()));
  EXPECT_EQ(store.bytes(), 100 + kTextureBytes);
  EXPECT_GT(store.changes(), before);
}

}  // namespace
}  // namespace burnish

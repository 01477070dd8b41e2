#include "common/wire/sheets_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(SheetsWire, AWishComesBack) {
  const SheetsWish wish{"head", {3, 1}, {7}, {{7, 0}, {0xffffffff, 5}}};
  const SheetsWish back = from_wire(to_wire(wish)).value();
  EXPECT_EQ(back.scan, wish.scan);
  EXPECT_EQ(back.blocks, wish.blocks);
  EXPECT_EQ(back.charts, wish.charts);
  EXPECT_EQ(back.sheets, wish.sheets);
}

TEST(SheetsWire, ASheetComesBack) {
  const SheetPart back = from_wire(to_wire(SheetPart{{9, 2}, {0, 255}}));
  EXPECT_EQ(back.number, (SheetNumber{9, 2}));
  EXPECT_EQ(back.bytes, (std::vector<uint8_t>{0, 255}));
}

TEST(SheetsWire, ADescriptionComesBack) {
  const SheetsDescription back =
      from_wire(to_wire(SheetsDescription{{1, 0, 255}, {{4, {9}}, {5, {}}}}));
  EXPECT_TRUE(back.has_sheets());
  EXPECT_EQ(back.head, (std::vector<uint8_t>{1, 0, 255}));
  ASSERT_EQ(back.blocks.size(), 2u);
  EXPECT_EQ(back.blocks[0].number, 4u);
  EXPECT_EQ(back.blocks[0].bytes, std::vector<uint8_t>{9});
  EXPECT_TRUE(back.blocks[1].bytes.empty());
}

TEST(SheetsWire, AnEmptyHeadSaysThatThereAreNoPictures) {
  EXPECT_FALSE(from_wire(to_wire(SheetsDescription{})).has_sheets());
}

TEST(SheetsWire, MoreThanTheLimitOrNothingIsRefused) {
  SheetsWish wish{"head", {}, std::vector<uint32_t>(kSheetPartsPerFetchMax - 1), {{0, 0}}};
  EXPECT_TRUE(from_wire(to_wire(wish)).is_ok());
  wish.blocks = {0};
  const Status many = from_wire(to_wire(wish)).status();
  EXPECT_EQ(many.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(many.message(), HasSubstr("65"));
  EXPECT_THAT(many.message(), HasSubstr("1..64"));
  EXPECT_THAT(from_wire(to_wire(SheetsWish{"head", {}, {}, {}})).status().message(),
              HasSubstr("0"));
}

TEST(SheetsWire, AWishNamesItsScan) {
  EXPECT_EQ(from_wire(to_wire(SheetsWish{"", {}, {0}, {}})).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace burnish

#include "common/wire/pages_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(PagesWire, AWishComesBack) {
  const PagesWish wish{"head", {3, 1}, {7, 0xffffffff}};
  const PagesWish back = from_wire(to_wire(wish)).value();
  EXPECT_EQ(back.scan, wish.scan);
  EXPECT_EQ(back.blocks, wish.blocks);
  EXPECT_EQ(back.pages, wish.pages);
}

TEST(PagesWire, ADescriptionComesBack) {
  const PagesDescription back =
      from_wire(to_wire(PagesDescription{{1, 0, 255}, {{4, {9}}, {5, {}}}}));
  EXPECT_EQ(back.head, (std::vector<uint8_t>{1, 0, 255}));
  ASSERT_EQ(back.blocks.size(), 2u);
  EXPECT_EQ(back.blocks[0].number, 4u);
  EXPECT_EQ(back.blocks[0].bytes, std::vector<uint8_t>{9});
  EXPECT_TRUE(back.blocks[1].bytes.empty());
}

TEST(PagesWire, MoreThanTheLimitOrNothingIsRefused) {
  PagesWish wish{"head", {}, std::vector<uint32_t>(kPagePartsPerFetchMax)};
  EXPECT_TRUE(from_wire(to_wire(wish)).is_ok());
  wish.blocks = {0};
  const Status many = from_wire(to_wire(wish)).status();
  EXPECT_EQ(many.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(many.message(), HasSubstr("65"));
  EXPECT_THAT(many.message(), HasSubstr("1..64"));
  EXPECT_THAT(from_wire(to_wire(PagesWish{"head", {}, {}})).status().message(), HasSubstr("0"));
}

TEST(PagesWire, AWishNamesItsScan) {
  EXPECT_EQ(from_wire(to_wire(PagesWish{"", {}, {0}})).status().code(),
            StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace burnish

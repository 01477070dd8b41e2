#include "common/wire/page_values_wire.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(PageValuesWire, ARequestComesBackUnchanged) {
  const PageValuesWish back =
      from_wire(to_wire(PageValuesWish{"work", CellValue::kKappa2, {7, 3}})).value();
  EXPECT_EQ(back.session, "work");
  EXPECT_EQ(back.value, CellValue::kKappa2);
  EXPECT_EQ(back.pages, (std::vector<PageId>{7, 3}));
}

TEST(PageValuesWire, ARequestNamesOneTo4096Pages) {
  PageValuesWish wish{"work", CellValue::kBeta, {}};
  EXPECT_THAT(from_wire(to_wire(wish)).status().message(), HasSubstr("0 pages is outside 1..4096"));
  wish.pages.resize(4096);
  EXPECT_TRUE(from_wire(to_wire(wish)).is_ok());
  wish.pages.resize(4097);
  EXPECT_THAT(from_wire(to_wire(wish)).status().message(), HasSubstr("4097"));
}

TEST(PageValuesWire, ARequestNamesAValueThatThereIs) {
  v1::GetPageValuesRequest message = to_wire(PageValuesWish{"work", CellValue::kBeta, {0}});
  message.set_value(static_cast<v1::CellValue>(8));
  EXPECT_EQ(from_wire(message).status().code(), StatusCode::kInvalidArgument);
}

TEST(PageValuesWire, ValuesComeBackUnchanged) {
  const PageValues back = from_wire(to_wire(PageValues{5, -1, 2, {0, 128, 255}})).value();
  EXPECT_EQ(back.page, 5u);
  EXPECT_EQ(back.low, -1);
  EXPECT_EQ(back.high, 2);
  EXPECT_EQ(back.steps, (std::vector<uint8_t>{0, 128, 255}));
}

TEST(PageValuesWire, ValuesOfAnotherProgramAreChecked) {
  v1::PageValues message = to_wire(PageValues{5, 0, 1, std::vector<uint8_t>(2048)});
  EXPECT_TRUE(from_wire(message).is_ok());
  message.set_steps(std::string(2049, 0));
  EXPECT_THAT(from_wire(message).status().message(), HasSubstr("2049"));
  message.set_steps("");
  message.set_high(NAN);
  EXPECT_EQ(from_wire(message).status().code(), StatusCode::kDataLoss);
}

}  // namespace
}  // namespace burnish

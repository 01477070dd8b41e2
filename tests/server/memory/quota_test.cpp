#include "server/memory/quota.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Quota, IsOfEachHolderAndNamesTheNumbers) {
  Quota quota("streams", "limits.streams_per_user", 3);
  const auto first = quota.take("user anna", 2);
  ASSERT_TRUE(first.is_ok());
  EXPECT_TRUE(quota.take("user bert", 3).is_ok());
  const Status status = quota.take("user anna", 2).status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_EQ(status.message(),
            "user anna has 2 streams and needs 2 more; limits.streams_per_user is 3");
  EXPECT_TRUE(quota.take("user anna", 1).is_ok());
}

TEST(Quota, ComesBackWithTheShare) {
  Quota quota("bytes", "k", 10);
  {
    Quota::Share moved;
    auto share = quota.take("a", 10);
    moved = std::move(share).value();
    EXPECT_EQ(quota.taken(), 10u);
    EXPECT_FALSE(quota.take("a", 1).is_ok());
  }
  EXPECT_EQ(quota.taken(), 0u);
  EXPECT_TRUE(quota.take("a", 10).is_ok());
}

TEST(Quota, MoreThanTheWholeIsRefusedAndNothingIsFree) {
  Quota quota("bytes", "k", 10);
  EXPECT_FALSE(quota.take("a", ~uint64_t{0}).is_ok());
  const auto all = quota.take("a", 10);
  EXPECT_TRUE(quota.take("a", 0).is_ok());
}

TEST(Quota, AShareGrowsAndShrinksWithinTheWhole) {
  Quota quota("bytes", "k", 10);
  Quota::Share share = std::move(quota.take("a", 2)).value();
  EXPECT_TRUE(share.resize(10).is_ok());
  EXPECT_EQ(quota.taken(), 10u);
  EXPECT_FALSE(share.resize(11).is_ok());
  EXPECT_EQ(share.amount(), 10u);
  EXPECT_TRUE(share.resize(3).is_ok());
  EXPECT_EQ(quota.taken(), 3u);
  EXPECT_TRUE(share.resize(0).is_ok());
  EXPECT_EQ(quota.taken(), 0u);
}

TEST(Quota, SharesOutliveIt) {
  Quota::Share share;
  {
    Quota quota("bytes", "k", 10);
    share = std::move(quota.take("a", 10)).value();
  }
  EXPECT_EQ(share.amount(), 10u);
}

}  // namespace
}  // namespace burnish

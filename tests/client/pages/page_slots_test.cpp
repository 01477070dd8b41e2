#include "client/pages/page_slots.h"

#include <gtest/gtest.h>

#include "client/pages/cut_targets.h"

namespace burnish {
namespace {

TEST(PageSlots, TheLowestFreeSlotIsTaken) {
  PageSlots slots(4);
  EXPECT_EQ(slots.take(), 0u);
  EXPECT_EQ(slots.take(), 1u);
  EXPECT_EQ(slots.take(), 2u);
  slots.give_back(1);
  slots.give_back(0);
  EXPECT_EQ(slots.take(), 0u);
  EXPECT_EQ(slots.take(), 1u);
  EXPECT_EQ(slots.begun(), 3u);
}

TEST(PageSlots, NoMoreThanTheBudgetAreTaken) {
  PageSlots slots(2);
  slots.take();
  slots.take();
  EXPECT_FALSE(slots.take().has_value());
  slots.give_back(0);
  EXPECT_EQ(slots.taken(), 1u);
  EXPECT_EQ(slots.take(), 0u);
}

TEST(PageSlots, TheDefaultBudgetHoldsThreeThousandPages) {
  EXPECT_EQ(PageBudget{}.slots(), 3051u);
}

}  // namespace
}  // namespace burnish

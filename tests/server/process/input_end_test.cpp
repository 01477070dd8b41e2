#include "server/process/input_end.h"

#include <unistd.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(InputEnd, APipeEndsWithTheLastOneWhoHoldsItsOtherEnd) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_FALSE(has_ended(ends[0]));
  ASSERT_EQ(write(ends[1], "words", 5), 5);
  EXPECT_FALSE(has_ended(ends[0]));
  const int second = dup(ends[1]);
  close(ends[1]);
  EXPECT_FALSE(has_ended(ends[0]));
  close(second);
  EXPECT_TRUE(has_ended(ends[0]));
  close(ends[0]);
  EXPECT_TRUE(has_ended(ends[0]));  // a closed input is no better
}

}  // namespace
}  // namespace burnish

#include "server/rpc/admission/cut_off_calls.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(CutOffCalls, ACallThatStaysMissingIsCountedOnce) {
  CutOffCalls calls;
  uint64_t counted = 0;
  for (int i = 0; i < 10; ++i) counted += calls.add(1);
  EXPECT_EQ(counted, 1u);
  for (int i = 0; i < 10; ++i) counted += calls.add(3);
  EXPECT_EQ(counted, 3u);
}

TEST(CutOffCalls, ACallWhoseMessageIsOnItsWayIsNotCounted) {
  CutOffCalls calls;
  uint64_t counted = 0;
  for (const uint64_t missing : {1, 2, 1, 0, 5, 1, 0, 0}) counted += calls.add(missing);
  EXPECT_EQ(counted, 0u);
}

}  // namespace
}  // namespace burnish

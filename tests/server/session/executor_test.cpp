#include "server/session/executor.h"

#include <atomic>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Executor, RunsEverythingThatWasPostedBeforeItEnds) {
  std::atomic<int> done{0};
  {
    Executor executor(3);
    for (int i = 0; i < 1000; ++i) executor.post([&] { ++done; });
  }
  EXPECT_EQ(done, 1000);
}

}  // namespace
}  // namespace burnish

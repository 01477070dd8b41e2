#include "client/raster/work_crew.h"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(WorkCrew, DoesEachPartOnceWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 5}) {
    WorkCrew crew(threads);
    EXPECT_EQ(crew.threads(), threads);
    for (const int parts : {0, 1, 3, 1000}) {
      std::vector<std::atomic<int>> done(parts);
      crew.run(parts, [&](int part) { ++done[part]; });
      for (const auto& each : done) EXPECT_EQ(each, 1);
    }
  }
}

}  // namespace
}  // namespace burnish

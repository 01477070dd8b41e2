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

TEST(WorkCrew, CountsTheTimeOfAllThreadsAndNoneOfItsWaits) {
  for (const int threads : {1, 3}) {
    WorkCrew crew(threads);
    EXPECT_EQ(crew.seconds(), 0);
    std::atomic<uint64_t> sum = 0;
    crew.run(6, [&](int part) {
      for (uint64_t i = 0; i < 1'000'000; ++i) sum += i * part;
    });
    const double worked = crew.seconds();
    EXPECT_GT(worked, 0);
    crew.run(0, [](int) {});
    EXPECT_LT(crew.seconds() - worked, worked);
  }
}

}  // namespace
}  // namespace burnish

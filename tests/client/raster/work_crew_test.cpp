#include "client/raster/work_crew.h"

#include <atomic>
#include <ctime>
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

double process_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// However long the machine lets it wait: the process runs no longer than its threads.
TEST(WorkCrew, CountsTheTimeOfAllThreadsAndNoneOfItsWaits) {
  for (const int threads : {1, 3}) {
    WorkCrew crew(threads);
    EXPECT_EQ(crew.seconds(), 0);
    std::atomic<uint64_t> sum = 0;
    const double before = process_seconds();
    crew.run(6, [&](int part) {
      for (uint64_t i = 0; i < 1'000'000; ++i) sum += i * part;
    });
    EXPECT_GT(crew.seconds(), 0);
    EXPECT_LE(crew.seconds(), process_seconds() - before);
  }
}

}  // namespace
}  // namespace burnish

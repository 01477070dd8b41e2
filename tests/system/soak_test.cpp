// The criterion of tests/system/soak: it finds a leak, and nothing else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr char kFolder[] = SOURCE_ROOT "/tests/system/";

CommandOutcome run_soak(const TemporaryFolder& folder, const std::vector<std::string>& words) {
  Process process(words, folder / "output");
  const int exit_code = process.wait(kPatience).value_or(-1);
  return {exit_code, process.output()};
}

/// Returns the slope of readings made each minute for an hour.
CommandOutcome slope_of(const std::function<double(int)>& megabytes_at) {
  const TemporaryFolder folder;
  std::string readings;
  for (int minute = 0; minute <= 60; ++minute)
    readings += std::to_string(60 * minute) + " " + std::to_string(megabytes_at(minute)) + "\n";
  return run_soak(
      folder, {"/usr/bin/env", "awk", "-v", "limit=10", "-v", "floor=2", "-f",
               std::string(kFolder) + "slope.awk", folder.write("readings", readings).string()});
}

TEST(Slope, WarmingUpAndAFewPeaksAreNoLeak) {
  const CommandOutcome outcome = slope_of(
      [](int minute) { return 100 + std::min(minute, 15) * 5.0 + (minute % 9 == 0 ? 40 : 0); });
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("+0.0 MB an hour, limit 10.0"));
}

TEST(Slope, ALeakIsFoundUnderPeaks) {
  const CommandOutcome outcome =
      slope_of([](int minute) { return 100 + minute * 0.25 + (minute % 9 == 0 ? 40 : 0); });
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("+15.0 MB an hour, limit 10.0"));
}

TEST(Soak, CatchesAServerThatLosesMemoryWithEachConnection) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer's library must be loaded first";
#endif
  const TemporaryFolder folder;
  const std::string programs = std::filesystem::path(BURNISH_BINARY).parent_path().string();
  const CommandOutcome outcome =
      run_soak(folder, {"/usr/bin/env", "BURNISH_BIN=" + programs,
                        std::string("BURNISH_SOAK_PRELOAD=") + LEAK_LIBRARY,
                        std::string(kFolder) + "soak", "0", "0.5"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("FAILED: resident memory grows"));
}

}  // namespace
}  // namespace burnish

#include "server/solver/device_probe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(DeviceProbe, TheProcessorsAreNoDeviceThatCouldFail) {
  EXPECT_FALSE(has_device(BackendKind::kCpu));
  EXPECT_TRUE(probe_device(BackendKind::kCpu).is_ok());
}

TEST(DeviceProbe, TheProcessorsAreNamedWithTheReasonForThem) {
  EXPECT_EQ(say_where_solved(BackendKind::kCpu), "the processors (requested)");
  const std::string by_itself = say_where_solved(BackendKind::kAuto);
  if (has_device(BackendKind::kAuto)) {
    EXPECT_THAT(by_itself, testing::StartsWith("CUDA ("));
  } else {
    EXPECT_THAT(by_itself, testing::MatchesRegex("the processors \\(.*CUDA.*\\)"));
    EXPECT_THAT(say_where_solved(BackendKind::kCuda), testing::StartsWith("nothing ("));
  }
}

}  // namespace
}  // namespace burnish

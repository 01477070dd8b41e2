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
  EXPECT_EQ(say_where_solved(BackendKind::kCpu).value(), "the processors (requested)");
  const std::string by_itself = say_where_solved(BackendKind::kAuto).value();
  if (has_device(BackendKind::kAuto)) {
    EXPECT_THAT(by_itself, testing::StartsWith("CUDA ("));
  } else {
    EXPECT_THAT(by_itself, testing::MatchesRegex("the processors \\(.*CUDA.*\\)"));
    const Status refused = say_where_solved(BackendKind::kCuda).status();
    EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
    EXPECT_THAT(refused.message(), testing::StartsWith("backend cuda: "));
  }
}

}  // namespace
}  // namespace burnish

#include "server/solver/device_probe.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(DeviceProbe, TheProcessorsAreNoDeviceThatCouldFail) {
  EXPECT_FALSE(has_device(BackendKind::kCpu));
  EXPECT_TRUE(probe_device(BackendKind::kCpu).is_ok());
}

}  // namespace
}  // namespace burnish

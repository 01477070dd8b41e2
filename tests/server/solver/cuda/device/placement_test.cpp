#include "server/solver/cuda/device/placement.h"

#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Placement, ASessionGoesWhereTheLeastIs) {
  EXPECT_EQ(least_loaded(std::vector<uint64_t>{5, 3, 4}), 1);
}

TEST(Placement, TheFirstOfEqualsIsTaken) {
  EXPECT_EQ(least_loaded(std::vector<uint64_t>{0, 0}), 0);
  EXPECT_EQ(least_loaded(std::vector<uint64_t>{7}), 0);
}

TEST(Placement, SessionsOfOneSizeSpreadEvenly) {
  std::vector<uint64_t> bytes(4), sessions(4);
  for (int i = 0; i < 64; ++i) {
    const int device = least_loaded(bytes);
    bytes[device] += 325'000'000;
    ++sessions[device];
  }
  EXPECT_EQ(sessions, std::vector<uint64_t>(4, 16));
}

}  // namespace
}  // namespace burnish

// Two servers and their database under random faults, while clients edit. A checker reads the
// recorded history. BURNISH_FLEET_ROUNDS=N does N faults instead of 5.

#include <cstdlib>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/environment.h"
#include "tests/system/faulty_fleet.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(FaultyFleet, LosesDoublesAndMisordersNoAcknowledgedEdit) {
  const int rounds = number_from_environment("BURNISH_FLEET_ROUNDS", 5);
  FaultyFleet fleet(1);
  for (int i = 0; i < rounds; ++i) fleet.fault();
  fleet.stop_clients();
  EXPECT_THAT(fleet.violations(), testing::IsEmpty());
  EXPECT_GT(fleet.edits(), 0u);
  std::cout << rounds << " faults, " << fleet.edits() << " edits, each of them there once\n";
}

// The other test means something only if this one holds.
TEST(FaultyFleet, WithoutTheFenceTwoServersWriteAtOnceAndTheCheckerSaysSo) {
  ::setenv("LD_PRELOAD", NO_FENCE_LIBRARY, 1);
  const auto fleet = std::make_unique<FaultyFleet>(1);
  ::unsetenv("LD_PRELOAD");
  const int rounds = number_from_environment("BURNISH_FLEET_ROUNDS", 3);
  for (int i = 0; i < rounds; ++i) {
    fleet->free_session();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // both servers get edits
  }
  fleet->stop_clients();
  EXPECT_THAT(fleet->violations(), testing::Contains(HasSubstr("two owners")));
}

}  // namespace
}  // namespace burnish

#include "server/solver/multi/lock_step.h"

#include <string>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(LockStep, RunsShardsInOrderBetweenBarriers) {
  for (const int shards : {1, 2, 5}) {
    LockStep steps(shards);
    for (int round = 0; round < 3; ++round) {
      std::string did;
      steps.run([&](int shard) {
        EXPECT_EQ(steps.current(), shard);
        did += static_cast<char>('a' + shard);
        steps.arrive_and_wait([&] { did += '|'; });
        did += static_cast<char>('a' + shard);
        steps.arrive_and_wait([&] { did += '|'; });
      });
      std::string all;
      for (int shard = 0; shard < shards; ++shard) all += static_cast<char>('a' + shard);
      EXPECT_EQ(did, all + "|" + all + "|");
      EXPECT_EQ(steps.current(), -1);
    }
  }
}

// A machine that failed makes its shard leave early.
TEST(LockStep, NobodyWaitsForAShardThatLeft) {
  for (const int leaves : {0, 1, 2}) {
    LockStep steps(3);
    int together = 0, ended = 0;
    steps.run([&](int shard) {
      steps.arrive_and_wait([&] { ++together; });
      if (shard != leaves) steps.arrive_and_wait([&] { ++together; });
      ++ended;
    });
    EXPECT_EQ(together, 1);
    EXPECT_EQ(ended, 3);
  }
}

}  // namespace
}  // namespace burnish

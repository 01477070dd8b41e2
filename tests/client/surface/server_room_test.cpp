#include "client/surface/server_room.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

const ServerRoom::Time kStart{std::chrono::hours(1)};

TEST(ServerRoom, AnyNumberIsShownUntilTheServerRefuses) {
  ServerRoom room;
  EXPECT_EQ(room.vertices_max(kStart), 0u);
  room.refuse(100'000, kStart);
  EXPECT_EQ(room.vertices_max(kStart), 50'000u);
}

TEST(ServerRoom, ASecondRefusalHalvesWhatWasShownThen) {
  ServerRoom room;
  room.refuse(100'000, kStart);
  room.refuse(50'000, kStart);
  EXPECT_EQ(room.vertices_max(kStart), 25'000u);
}

TEST(ServerRoom, SomePagesAreAlwaysAskedFor) {
  ServerRoom room;
  room.refuse(10, kStart);
  EXPECT_EQ(room.vertices_max(kStart), ServerRoom::kVerticesMin);
}

TEST(ServerRoom, RisesSlowlyToWhatWasRefusedAndBeyond) {
  ServerRoom room;
  room.refuse(100'000, kStart);
  EXPECT_EQ(room.vertices_max(kStart + ServerRoom::kFirstPause), 56'250u);
  ServerRoom::Time now = kStart + ServerRoom::kFirstPause;
  uint64_t last = 56'250;
  for (int step = 0; step < 10 && last != 0; ++step) {
    now += ServerRoom::kFirstPause;
    const uint64_t next = room.vertices_max(now);
    EXPECT_TRUE(next == 0 || next > last) << next;
    last = next;
  }
  EXPECT_EQ(last, 0u);
}

TEST(ServerRoom, EachRefusalDoublesThePause) {
  ServerRoom room;
  room.refuse(100'000, kStart);
  room.refuse(100'000, kStart);
  EXPECT_EQ(room.vertices_max(kStart + ServerRoom::kFirstPause), 50'000u);
  EXPECT_EQ(room.vertices_max(kStart + 2 * ServerRoom::kFirstPause), 56'250u);
}

}  // namespace
}  // namespace burnish

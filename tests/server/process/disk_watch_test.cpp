#include "server/process/disk_watch.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr uint64_t kGiB = uint64_t{1} << 30;
constexpr uint64_t kMiB = uint64_t{1} << 20;

TEST(DiskWatch, EachLevelIsToldOnceUntilThereWasMore) {
  DiskWatch watch;
  EXPECT_FALSE(watch.look(100 * kGiB));
  EXPECT_EQ(watch.look(5 * kGiB), 8 * kGiB);
  EXPECT_FALSE(watch.look(4 * kGiB));
  EXPECT_EQ(watch.look(kGiB / 8), kGiB / 4);  // both levels at once are one warning
  EXPECT_FALSE(watch.look(kGiB / 2));
  EXPECT_EQ(watch.look(kGiB / 8), kGiB / 4);
}

TEST(DiskWatch, AnAlmostFullDiskIsToldAsItFills) {
  DiskWatch watch;
  EXPECT_EQ(watch.look(200 * kMiB), 256 * kMiB);
  EXPECT_EQ(watch.look(60 * kMiB), 64 * kMiB);
  EXPECT_EQ(watch.look(0), 8 * kMiB);
}

}  // namespace
}  // namespace burnish

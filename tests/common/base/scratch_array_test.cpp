#include "common/base/scratch_array.h"

#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr size_t kEntries = 100'000;
constexpr uint64_t kBytes = kEntries * sizeof(uint32_t);

// Tests run at the same time, so each has a folder of its own.
class ScratchFolder : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(ScratchFolder, ArraysInMemoryAndInFilesBeginAsZerosAndKeepWhatIsWritten) {
  for (const uint64_t memory_bytes_max : {uint64_t{0}, 2 * kBytes}) {
    const ScratchSpace space(folder_.path(), memory_bytes_max);
    ScratchArray<uint32_t> array(space, kEntries);
    EXPECT_EQ(std::ranges::count(array, 0u), kEntries);
    std::iota(array.begin(), array.end(), 0);
    const ScratchArray<uint32_t> copy = copy_to(space, array);
    const ScratchArray<uint32_t> moved = std::move(array);
    EXPECT_EQ(moved.back(), kEntries - 1);
    EXPECT_TRUE(std::ranges::equal(moved, copy));
  }
}

TEST_F(ScratchFolder, ArraysBeyondTheLimitOfMemoryLieInFilesWithoutNames) {
  const ScratchSpace space(folder_.path(), kBytes);
  ScratchArray<uint32_t> first(space, kEntries);
  EXPECT_EQ(space.memory_bytes(), kBytes);
  ScratchArray<uint32_t> second(space, kEntries);
  EXPECT_EQ(space.memory_bytes(), kBytes);
  second[kEntries / 2] = 7;
  EXPECT_EQ(second[kEntries / 2], 7u);
  EXPECT_EQ(folder_.file_count(), 0u);
  first = {};
  EXPECT_EQ(space.memory_bytes(), 0u);
}

TEST_F(ScratchFolder, CopiesOfASpaceShareItsLimit) {
  const ScratchSpace space(folder_.path(), kBytes);
  const ScratchSpace copy = space;  // NOLINT(performance-unnecessary-copy-initialization)
  const ScratchArray<uint32_t> array(copy, kEntries);
  EXPECT_EQ(space.memory_bytes(), kBytes);
}

TEST_F(ScratchFolder, AFileThatDoesNotFitNamesItsBytesAndTheFolder) {
  const std::filesystem::path missing = folder_ / "missing";
  const ScratchSpace space(missing, 0);
  try {
    const ScratchArray<uint32_t> array(space, kEntries);
    FAIL() << "an array lies in a folder that does not exist";
  } catch (const ScratchFull& full) {
    EXPECT_THAT(full.what(), HasSubstr(std::to_string(kBytes) + " bytes"));
    EXPECT_THAT(full.what(), HasSubstr(missing.string()));
  }
}

TEST(ScratchArray, OfNothingHasNoEntries) {
  const ScratchArray<uint32_t> array(ScratchSpace(), 0);
  EXPECT_TRUE(array.empty());
  EXPECT_EQ(array.begin(), array.end());
}

}  // namespace
}  // namespace burnish

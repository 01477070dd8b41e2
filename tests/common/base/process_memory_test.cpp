#include "common/base/process_memory.h"

#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr uint64_t kBlockBytes = 64 << 20;

// Makes a block resident and lets it go again.
uint64_t resident_with_block() {
  const std::vector<char> block(kBlockBytes, 1);
  return block.back() == 1 ? resident_bytes() : 0;
}

TEST(ProcessMemory, ABlockInUseIsResident) {
  const uint64_t before = resident_bytes();
  EXPECT_GT(before, 0u);
  EXPECT_GT(resident_with_block(), before + kBlockBytes / 2);
}

TEST(ProcessMemory, ThePeakRemembersWhatIsGone) {
  const uint64_t with_block = resident_with_block();
  EXPECT_LT(resident_bytes(), with_block - kBlockBytes / 2);
  EXPECT_GE(peak_resident_bytes(), with_block - kBlockBytes / 2);
}

TEST(ProcessMemory, AResetPeakStartsFromWhatIsResident) {
  const uint64_t with_block = resident_with_block();
  if (!reset_peak_resident_bytes()) GTEST_SKIP() << "this system does not permit the reset";
  EXPECT_LT(peak_resident_bytes(), with_block - kBlockBytes / 2);
}

}  // namespace
}  // namespace burnish

#include "common/base/process_memory.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

namespace burnish {
namespace {

constexpr uint64_t kBlockBytes = 64 << 20;

// Makes a block resident and lets it go again; mapped by hand, as an allocator may keep it.
uint64_t resident_with_block() {
  void* block = mmap(nullptr, kBlockBytes, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
  EXPECT_NE(block, MAP_FAILED);
  const uint64_t resident = resident_bytes();
  munmap(block, kBlockBytes);
  return resident;
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

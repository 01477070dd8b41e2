#include "common/base/process_memory.h"

#include <limits>

#include <gtest/gtest.h>
#include <sys/mman.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

constexpr uint64_t kBlockBytes = 64 << 20;

// Makes a block resident and releases it. Maps it directly, because an allocator may keep memory.
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

/// A machine's /proc and /sys with the test's cgroups.
class CgroupMemory : public testing::Test {
 protected:
  void write(const std::string& path, const std::string& content) const {
    std::filesystem::create_directories((root_ / path).parent_path());
    root_.write(path, content);
  }
  uint64_t limit() const { return cgroup_memory_bytes_max(root_ / ""); }

  static constexpr uint64_t kNoLimit = std::numeric_limits<uint64_t>::max();
  TemporaryFolder root_;
};

TEST_F(CgroupMemory, WithoutCgroupsThereIsNoLimit) {
  EXPECT_EQ(limit(), kNoLimit);
}

TEST_F(CgroupMemory, MaxIsNoLimit) {
  write("proc/self/cgroup", "0::/\n");
  write("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(limit(), kNoLimit);
}

TEST_F(CgroupMemory, TheSmallestLimitAboveTheProcessCounts) {
  write("proc/self/cgroup", "0::/system.slice/burnish.service\n");
  write("sys/fs/cgroup/system.slice/burnish.service/memory.max", "max\n");
  write("sys/fs/cgroup/system.slice/memory.max", "1073741824\n");
  write("sys/fs/cgroup/memory.max", "2147483648\n");
  EXPECT_EQ(limit(), 1'073'741'824u);
}

TEST_F(CgroupMemory, TheFirstVersionsLimitCounts) {
  write("proc/self/cgroup", "9:name=systemd:/a\n4:cpu,memory:/a/b\n0::/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("sys/fs/cgroup/memory/a/b/memory.limit_in_bytes", "536870912\n");
  EXPECT_EQ(limit(), 536'870'912u);
}

TEST_F(CgroupMemory, AContainerThatDoesNotSeeItsOwnPathHasTheLimitOfItsRoot) {
  write("proc/self/cgroup", "0::/docker/0123456789abcdef\n");
  write("sys/fs/cgroup/memory.max", "1000000\n");
  EXPECT_EQ(limit(), 1'000'000u);
}

TEST(MachineMemory, ItIsNoMoreThanTheCgroupsAllow) {
  EXPECT_GT(machine_memory_bytes(), 0u);
  EXPECT_LE(machine_memory_bytes(), cgroup_memory_bytes_max());
}

}  // namespace
}  // namespace burnish

#include "common/base/process_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>

namespace burnish {

namespace fs = std::filesystem;

static constexpr uint64_t kNoLimit = std::numeric_limits<uint64_t>::max();

// Returns the value of a "Name:   123 kB" line, or `otherwise` if there is no such line.
static uint64_t bytes_of_line(const char* file, const std::string& name, uint64_t otherwise) {
  std::ifstream in(file);
  std::string word;
  while (in >> word) {
    if (word != name) continue;
    uint64_t kibibytes = 0;
    return in >> kibibytes ? kibibytes * 1024 : otherwise;
  }
  return otherwise;
}

uint64_t resident_bytes() {
  return bytes_of_line("/proc/self/status", "VmRSS:", 0);
}

uint64_t anonymous_bytes() {
  return bytes_of_line("/proc/self/status", "RssAnon:", 0);
}

uint64_t peak_resident_bytes() {
  return bytes_of_line("/proc/self/status", "VmHWM:", 0);
}

bool reset_peak_resident_bytes() {
  std::ofstream clear_refs("/proc/self/clear_refs");
  clear_refs << "5" << std::flush;  // 5: the high-water mark only; proc(5)
  return clear_refs.good();
}

uint64_t available_memory_bytes() {
  return bytes_of_line("/proc/meminfo", "MemAvailable:", kNoLimit);
}

// Returns the smallest number in the files of this name, from `group` up to `mount`. A file without
// a limit says "max". In a container the path may be a path of the host. Then the mount itself is
// the container's group, where the walk ends.
static uint64_t smallest_limit(const fs::path& mount, fs::path group, const char* name) {
  uint64_t smallest = kNoLimit;
  for (;;) {
    uint64_t bytes = 0;
    if (std::ifstream(mount / group / name) >> bytes) smallest = std::min(smallest, bytes);
    if (group.empty()) return smallest;
    group = group.parent_path();
  }
}

uint64_t cgroup_memory_bytes_max(const fs::path& root) {
  const fs::path mounts = root / "sys/fs/cgroup";
  std::ifstream groups(root / "proc/self/cgroup");
  uint64_t smallest = kNoLimit;
  for (std::string line; std::getline(groups, line);) {  // "0::/a/b", or "4:cpu,memory:/a/b"
    const size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const fs::path group = fs::path(line.substr(second + 1)).relative_path();
    if (controllers == ",,")
      smallest = std::min(smallest, smallest_limit(mounts, group, "memory.max"));
    else if (controllers.find(",memory,") != std::string::npos)
      smallest =
          std::min(smallest, smallest_limit(mounts / "memory", group, "memory.limit_in_bytes"));
  }
  return smallest;
}

uint64_t machine_memory_bytes() {
  const uint64_t pages = static_cast<uint64_t>(sysconf(_SC_PHYS_PAGES));
  const uint64_t page_bytes = static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
  return std::min(pages * page_bytes, cgroup_memory_bytes_max());
}

}  // namespace burnish

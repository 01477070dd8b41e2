#include "common/base/process_memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace burnish {

// The value of a "Name:   123 kB" line, or `otherwise` where there is none.
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

uint64_t peak_resident_bytes() {
  return bytes_of_line("/proc/self/status", "VmHWM:", 0);
}

bool reset_peak_resident_bytes() {
  std::ofstream clear_refs("/proc/self/clear_refs");
  clear_refs << "5" << std::flush;  // 5: the high-water mark only; proc(5)
  return clear_refs.good();
}

uint64_t available_memory_bytes() {
  return bytes_of_line("/proc/meminfo", "MemAvailable:", std::numeric_limits<uint64_t>::max());
}

}  // namespace burnish

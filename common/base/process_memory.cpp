#include "common/base/process_memory.h"

#include <fstream>
#include <limits>
#include <string>
#include <string_view>

namespace burnish {

// Linux gives these in lines like "VmRSS:     1234 kB".
static uint64_t bytes_in_status(std::string_view field) {
  std::ifstream status("/proc/self/status");
  std::string name;
  while (status >> name) {
    uint64_t kibibytes = 0;
    if (name == field && status >> kibibytes) return kibibytes * 1024;
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return 0;
}

uint64_t resident_bytes() {
  return bytes_in_status("VmRSS:");
}

uint64_t peak_resident_bytes() {
  return bytes_in_status("VmHWM:");
}

bool reset_peak_resident_bytes() {
  std::ofstream clear_refs("/proc/self/clear_refs");
  clear_refs << "5" << std::flush;  // 5: the high-water mark only; proc(5)
  return clear_refs.good();
}

}  // namespace burnish

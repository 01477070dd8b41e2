#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unistd.h>

#include <sys/mman.h>
#include <sys/stat.h>

#include "common/base/check.h"

namespace burnish {

/// A file in memory, for readers that take a path.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const uint8_t> bytes) : fd_(memfd_create("fuzzed", MFD_CLOEXEC)) {
    BURNISH_CHECK(::fchmod(fd_, 0600) == 0, "the file in memory cannot be closed to others");
    BURNISH_CHECK(::write(fd_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
                  "the file in memory cannot be written");
  }
  ~MemoryFile() { ::close(fd_); }
  std::string path() const { return "/proc/self/fd/" + std::to_string(fd_); }

 private:
  const int fd_;
};

}  // namespace burnish

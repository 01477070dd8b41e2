#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace burnish {

/// Says once when the disk falls below each of a few levels. It says so again after there was more.
class DiskWatch {
 public:
  /// Returns the lowest level that the disk has newly fallen below, in bytes.
  std::optional<uint64_t> look(uint64_t free_bytes);

 private:
  size_t passed_ = 0;  // levels that the disk is below
};

}  // namespace burnish

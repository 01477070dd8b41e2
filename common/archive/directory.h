#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// Private to this folder: what the directory at an archive's end says of an entry.
struct DirectoryRecord {
  std::string_view name;
  uint16_t flags = 0;
  uint16_t method = 0;
  uint32_t crc = 0;
  uint64_t packed_bytes = 0;
  uint64_t bytes = 0;
  uint64_t header = 0;  ///< where the entry's own header begins
};

/// Reads the directory, ZIP64 too. The names refer to `archive`. Fails: invalid_argument.
Result<std::vector<DirectoryRecord>> read_directory(std::span<const uint8_t> archive);

/// Compares an entry's own header with the directory: a program that reads from the front must find
/// what one that reads from the end finds. Sizes and sum may be missing in the header if they
/// follow the entry; macOS leaves out some of them only. Fails: invalid_argument.
Status check_header(std::span<const uint8_t> archive, const DirectoryRecord& record);

}  // namespace burnish

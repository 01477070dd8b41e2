#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "common/packing/checksum.h"
#include "common/packing/zstd_frame.h"

namespace burnish {

/// Makes the checksum at the end of a header right. Leaves bytes that are shorter.
inline void seal_part(std::span<uint8_t> bytes, size_t header_bytes) {
  if (bytes.size() < header_bytes) return;
  const size_t at = header_bytes - sizeof(uint64_t);
  const uint64_t checksum = sealed_checksum(bytes, at, header_bytes);
  std::memcpy(bytes.data() + at, &checksum, sizeof(checksum));
}

/// Compresses what lies behind the header and makes the checksum right. So changed bytes get
/// further than to zstd.
inline std::vector<uint8_t> compressed(std::span<const uint8_t> bytes, size_t header_bytes) {
  const size_t header = std::min(header_bytes, bytes.size());
  std::vector<uint8_t> sealed(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(header));
  append_compressed(bytes.subspan(header), 1, sealed);
  seal_part(sealed, header_bytes);
  return sealed;
}

}  // namespace burnish

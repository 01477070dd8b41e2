#include "common/packing/checksum.h"

#include <xxhash.h>

namespace burnish {

uint64_t sealed_checksum(std::span<const uint8_t> bytes, size_t checksum_at, size_t body_begin) {
  const uint64_t of_header = XXH3_64bits(bytes.data(), checksum_at);
  const auto body = bytes.subspan(body_begin);
  return XXH3_64bits_withSeed(body.data(), body.size(), of_header);
}

}  // namespace burnish

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Files travel as chunks in order and without gaps, each with its own checksum.
inline constexpr size_t kChunkBytes = size_t{1} << 20;     // what this program sends
inline constexpr size_t kChunkBytesMax = size_t{4} << 20;  // what this program accepts

/// Returns the CRC-32 of zlib and PNG.
uint32_t chunk_crc32(std::string_view data);

/// Fails: invalid_argument (size), data_loss (a gap, or bytes damaged in transfer). The message
/// names the offset.
Status check_chunk(uint64_t expected_offset, uint64_t offset, std::string_view data,
                   uint32_t crc32);

}  // namespace burnish

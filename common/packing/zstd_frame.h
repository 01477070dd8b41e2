#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// Appends the sections, one behind the other, as one zstd frame that says its size. A section is
/// a block of its own at least, so that each has its own code lengths.
void append_compressed(std::span<const std::span<const uint8_t>> sections, int zstd_level,
                       std::vector<uint8_t>& bytes);

/// Appends `body` as one zstd frame that says its size.
void append_compressed(std::span<const uint8_t> body, int zstd_level, std::vector<uint8_t>& bytes);

/// Returns how many bytes the first zstd frame takes. Fails: data_loss if the bytes do not begin
/// with a whole frame.
Result<size_t> compressed_bytes(std::span<const uint8_t> bytes);

/// Fails: data_loss if the bytes are not one zstd frame that says `size` and holds as many bytes.
/// A frame that says another size takes no memory.
Result<std::vector<uint8_t>> decompress(std::span<const uint8_t> bytes, size_t size);

}  // namespace burnish

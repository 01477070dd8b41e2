#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// Appends `body` as one zstd frame of level 1.
void append_compressed(std::span<const uint8_t> body, std::vector<uint8_t>& bytes);

/// Fails: data_loss if the bytes are not one zstd frame of exactly `size` bytes.
Result<std::vector<uint8_t>> decompress(std::span<const uint8_t> bytes, size_t size);

}  // namespace burnish

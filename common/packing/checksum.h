#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace burnish {

/// Returns the XXH3 of the bytes from `body_begin` on, seeded with the XXH3 of the bytes before
/// `checksum_at`. So a format's header keeps the checksum of all but itself as its last field.
/// Needs: checksum_at <= body_begin <= the bytes.
uint64_t sealed_checksum(std::span<const uint8_t> bytes, size_t checksum_at, size_t body_begin);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>

namespace burnish {

/// Returns whether packed attributes are of version 1, which KHR_meshopt_compression adds.
bool is_meshopt_version_1(std::span<const uint8_t> packed);

/// Unpacks attributes of version 1: appendix A, mode 0 of KHR_meshopt_compression. `stride` is the
/// size of an element. Returns false if the bytes are damaged. Needs: a stride that is a multiple
/// of 4 and at most 256; room for whole elements.
bool unpack_meshopt_attributes(std::span<const uint8_t> packed, uint64_t stride,
                               std::span<uint8_t> elements);

/// Turns colours of 4 or 8 bytes into RGBA in place: appendix B, filter 4. `stride` is their size.
void apply_meshopt_colour_filter(std::span<uint8_t> elements, uint64_t stride);

}  // namespace burnish

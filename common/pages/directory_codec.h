#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/pages/directory.h"

namespace burnish {

/// Packs the head in the format of page_format.h.
std::vector<uint8_t> encode_head(const PageHead& head);

/// Safe for any bytes. Fails: data_loss that names the damage; unimplemented (another version).
Result<PageHead> decode_head(std::span<const uint8_t> bytes);

/// Returns the checksum in an encoded head. It names the pages of a scan: page files with the same
/// head have the same pages. Needs: a whole head.
uint64_t pages_fingerprint(std::span<const uint8_t> encoded_head);

/// Packs one block of a directory. Needs: at most kPagesPerBlock entries and kCoarserPerBlockMax
/// coarser pages.
std::vector<uint8_t> encode_block(const DirectoryBlock& block);

/// Safe for any bytes. Fails: data_loss that names the damage, also if the block is not the one
/// that the head lists at `index`; unimplemented (another version).
Result<DirectoryBlock> decode_block(std::span<const uint8_t> bytes, const PageHead& head,
                                    uint32_t index);

}  // namespace burnish

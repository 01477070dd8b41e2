#include "common/transfer/chunk.h"

namespace burnish {

Status check_chunk(uint64_t expected_offset, uint64_t offset, std::string_view data,
                   uint32_t crc32) {
  const std::string where = "the chunk at offset " + std::to_string(offset);
  if (data.empty() || data.size() > kChunkBytesMax)
    return invalid_argument(where + " has " + std::to_string(data.size()) + " bytes, outside 1.." +
                            std::to_string(kChunkBytesMax));
  if (offset != expected_offset)
    return data_loss(where + " should begin at " + std::to_string(expected_offset));
  if (chunk_crc32(data) != crc32)
    return data_loss(where + " was damaged in transfer (its CRC-32 differs)");
  return Status::ok();
}

}  // namespace burnish

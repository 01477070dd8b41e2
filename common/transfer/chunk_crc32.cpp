#include <zlib.h>

#include "common/transfer/chunk.h"

namespace burnish {

uint32_t chunk_crc32(std::string_view data) {
  return static_cast<uint32_t>(
      crc32_z(0, reinterpret_cast<const unsigned char*>(data.data()), data.size()));
}

}  // namespace burnish

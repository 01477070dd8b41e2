#include "common/base/limits.h"
#include "common/gltf/document.h"
#include "common/mesh/mesh_io.h"

namespace burnish {

Result<uint64_t> predict_reading_bytes(std::span<const uint8_t> bytes, MeshFormat format,
                                       const std::string&) {
  if (format != MeshFormat::kGlb && format != MeshFormat::kGltf)
    return bytes.size() * kReadingBytesPerFileByte;
  return kGltfUnpackedBytesMin + bytes.size() * gltf_bytes_per_file_byte(bytes);
}

}  // namespace burnish

#include "common/base/limits.h"
#include "common/base/mapped_file.h"
#include "common/gltf/document.h"
#include "common/mesh/mesh_io.h"

namespace burnish {

Result<uint64_t> reading_bytes_max(const std::filesystem::path& path, MeshFormat format) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  const uint64_t bytes = file.bytes().size();
  if (format != MeshFormat::kGlb && format != MeshFormat::kGltf)
    return bytes * kReadingBytesPerFileByte;
  return kGltfUnpackedBytesMin + bytes * gltf_bytes_per_file_byte(file.bytes());
}

}  // namespace burnish

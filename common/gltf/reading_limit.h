#pragma once

#include <cstdint>

#include "common/gltf/json_access.h"

namespace burnish {

/// Returns how many bytes reading may make of a file: kGltfUnpackedBytesMin, and
/// kReadingBytesPerFileByte times the bytes of its meshes. Pictures in views of their own are none
/// of these. Meshes that Draco or meshopt packs count as large as their accessors say, but at most
/// kGltfUnpackedBytesPerPackedByte times their bytes in the file.
uint64_t gltf_reading_bytes_max(const GltfJson& json, uint64_t file_bytes);

}  // namespace burnish

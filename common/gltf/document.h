#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "common/gltf/container.h"
#include "common/gltf/json_access.h"

namespace burnish {

/// Returns the bytes of a file by its path beside a glTF file. They outlive the document. Checks
/// the path: it comes from the file.
using GltfFilesBeside =
    std::function<Result<std::span<const uint8_t>>(const std::string& relative_path)>;

/// One of a document's buffers.
struct GltfBuffer {
  enum class Home {
    kChunk,    ///< the BIN chunk
    kText,     ///< a data URI in the JSON
    kBeside,   ///< a file beside it
    kNowhere,  ///< only compressed views refer to it
  };
  Home home = Home::kNowhere;
  std::string path;                ///< of a file beside it
  std::vector<uint8_t> decoded;    ///< of a data URI
  std::span<const uint8_t> bytes;  ///< as many as the buffer's byteLength
};

/// A glTF 2.0 file, binary or as text. Its spans refer to the bytes that it was opened from.
struct GltfDocument {
  GltfJson json;
  bool is_binary = false;
  GlbParts parts;  ///< of a binary file
  std::vector<GltfBuffer> buffers;
  uint64_t file_bytes = 0;         ///< with the files beside it
  uint64_t reading_bytes_max = 0;  ///< gltf_reading_bytes_max()
};

/// Opens a .glb or a .gltf file. Fails: invalid_argument for a damaged file, another version, an
/// extension that is required and unknown, a file beside it without `beside`; as `beside` does.
Result<GltfDocument> open_gltf(std::span<const uint8_t> bytes,
                               const GltfFilesBeside& beside = nullptr,
                               const FileSteps& steps = {});

/// Returns the JSON of a .glb or a .gltf file. Fails: invalid_argument for a damaged file.
Result<GltfJson> read_gltf_json(std::span<const uint8_t> bytes);

/// Returns how a buffer view is packed by meshopt; null if it is not.
const GltfJson* find_meshopt(const GltfJson& view);

/// Returns a URI's text with its escapes replaced: "a%20b" is "a b".
std::string unescaped_uri(std::string_view uri);

inline constexpr const char* kDracoExtension = "KHR_draco_mesh_compression";
/// The second has the members of the first.
inline constexpr std::array<const char*, 2> kMeshoptExtensions = {"EXT_meshopt_compression",
                                                                  "KHR_meshopt_compression"};

}  // namespace burnish

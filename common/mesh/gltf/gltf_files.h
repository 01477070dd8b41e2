#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/gltf/document.h"
#include "common/mesh/files/files_beside.h"

namespace burnish {

/// Gives a glTF reader the files beside it, and keeps their bytes.
class GltfFiles {
 public:
  explicit GltfFiles(MeshSurroundings beside) : beside_(std::move(beside)) {}

  /// Null without surroundings. Needs: this outlives the reader and what it opens.
  GltfFilesBeside reader();

  /// Returns the path of a file among the surroundings. Needs: the reader has given it.
  const std::string& path_of(const std::string& name) const { return files_.at(name).path; }

 private:
  struct File {
    std::string path;
    std::vector<uint8_t> bytes;
  };
  Result<std::span<const uint8_t>> read(const std::string& name);

  MeshSurroundings beside_;
  std::map<std::string, File> files_;  // by the name in the glTF file
};

/// The files that a .glb or .gltf file names.
struct GltfNames {
  std::vector<std::string> buffers;
  std::vector<std::string> images;
};

/// Fails: invalid_argument for a damaged file.
Result<GltfNames> names_in_gltf(std::span<const uint8_t> bytes);

}  // namespace burnish

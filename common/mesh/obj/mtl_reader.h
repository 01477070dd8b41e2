#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/textures/texture_wrap.h"

namespace burnish {

/// A material of an MTL file, as far as its base colour goes.
struct Material {
  std::string name;
  std::optional<Rgba8> diffuse;           ///< Kd
  std::string picture;                    ///< map_Kd, else map_Ka or map_Ke, as named; empty: none
  TextureWraps wraps;                     ///< -clamp
  std::array<double, 2> scale = {1, 1};   ///< -s: u and v are multiplied
  std::array<double, 2> offset = {0, 0};  ///< -o: and then moved
};

/// Content of an MTL file.
struct MaterialFile {
  std::vector<Material> materials;
  std::vector<std::string> pictures;  ///< of all statements, each name once, in the file's order
};

/// Reads an MTL file; skips statements that it does not know. `name` is for messages. `steps` hears
/// of each line and word.
/// Fails: invalid_argument (more than kMaterialFileBytesMax bytes, a line above kLineBytesMax).
Result<MaterialFile> read_material_file(std::span<const uint8_t> bytes, const std::string& name,
                                        const FileSteps& steps = {});

}  // namespace burnish

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/mesh/mtl_reader.h"

namespace burnish {

/// Says where on which material a vertex lies: by the first face that has it.
struct TextureUses {
  static constexpr uint32_t kNone = UINT32_MAX;
  std::vector<std::array<float, 2>> coordinates;  ///< the file's `vt`
  std::vector<uint32_t> coordinate_of;            ///< per vertex, or kNone
  std::vector<uint32_t> material_of;              ///< per vertex, or kNone
};

/// Reads `vt`, `usemtl` and `f` of an OBJ file with `vertices` vertices. References that lead
/// nowhere count as none; read_obj() has checked those to vertices.
TextureUses gather_texture_uses(std::span<const uint8_t> obj, size_t vertices,
                                std::span<const Material> materials);

}  // namespace burnish

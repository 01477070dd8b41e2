#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/mesh/ply/ply_header.h"

namespace burnish {

/// Slots of a vertex's properties: axes 0 to 2, then the channels red, green, blue, alpha.
inline constexpr size_t kPlyRed = 3;
inline constexpr size_t kPlyIgnored = 7;

inline constexpr size_t kPlyNoList = SIZE_MAX;

/// Which properties of a PLY file make its mesh; all others are skipped.
struct PlyLayout {
  uint64_t vertices = 0;
  std::vector<size_t> vertex_slots;  ///< one per property of element vertex, kPlyIgnored for most
  bool has_colours = false;          ///< the file has red, green and blue
  bool has_double_positions = false;
  size_t face_list = kPlyNoList;   ///< the property of element face that lists its corners
  size_t strip_list = kPlyNoList;  ///< the same of element tristrips
};

/// Fails: invalid_argument if positions or faces are missing or have an unusable type.
Result<PlyLayout> find_ply_layout(const PlyHeader& header, const std::string& name);

}  // namespace burnish

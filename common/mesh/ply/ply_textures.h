#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace burnish {

/// Returns the pictures that a PLY names, as MeshLab does: "comment TextureFile skin.png", in small
/// or capital letters. Returns none for another file.
std::vector<std::string> textures_in_ply(std::span<const uint8_t> bytes);

}  // namespace burnish

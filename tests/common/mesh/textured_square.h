#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/mesh/files/files_beside.h"
#include "common/picture/picture.h"

namespace burnish {

/// A square of two triangles. Its texture coordinates are the centres of a picture's four pixels,
/// counted from the bottom.
inline const std::string kSquareObj =
    "mtllib square.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "vt 0.25 0.25\nvt 0.75 0.25\nvt 0.75 0.75\nvt 0.25 0.75\n"
    "usemtl skin\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

inline const std::string kSquareMtl = "newmtl skin\nKd 0.5 0.5 0.5\nmap_Kd skin.png\n";

/// Red and green on top, blue and grey below.
inline Picture square_picture() {
  return {2, 2, {{200, 0, 0, 255}, {0, 200, 0, 255}, {0, 0, 200, 255}, {90, 90, 90, 255}}};
}

/// The means of what the square's vertices own.
inline std::vector<Rgba8> square_colours() {
  return {{105, 75, 151, 255}, {82, 111, 111, 255}, {105, 151, 75, 255}, {165, 88, 88, 255}};
}

/// Files in memory.
class FilesInMemory final : public FilesBeside {
 public:
  std::map<std::string, std::string> files;

  Result<std::vector<uint8_t>> read(const std::string& path) const override {
    const std::string& text = files.at(path);
    return std::vector<uint8_t>(text.begin(), text.end());
  }

 private:
  std::optional<std::string> locate(const std::string& path) const override {
    return files.contains(path) ? std::optional(path) : std::nullopt;
  }
};

}  // namespace burnish

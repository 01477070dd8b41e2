#pragma once

#include <filesystem>
#include <string>

#include "tests/common/temporary_folder.h"

namespace burnish {

inline const std::string kBundledObj =
    "mtllib scan.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";

/// A folder with an OBJ, its material file, two pictures, and a file that nobody names.
class TexturedFolder : public TemporaryFolder {
 public:
  TexturedFolder() {
    std::filesystem::create_directory(*this / "maps");
    write("scan.obj", kBundledObj);
    write("scan.mtl",
          "newmtl a\nmap_Kd maps/skin.gif\nmap_Bump gone.png\nmap_Ks -bm 2 shine.gif\n");
    write("maps/skin.gif", "skin");
    write("shine.gif", "shine");
    write("notes.txt", "private");
  }
};

}  // namespace burnish

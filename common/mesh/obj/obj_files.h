#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/mesh/files/files_beside.h"
#include "common/mesh/obj/mtl_reader.h"

namespace burnish {

/// The files that an OBJ names, and those that its material files name.
struct ObjFiles {
  std::vector<std::string> found;    ///< paths of material files and pictures, each once
  std::vector<std::string> missing;  ///< names, as the texts have them, each once
  std::vector<Material> materials;   ///< `picture` is a path, or empty where it is missing
};

/// Reads the material files of an OBJ. Fails: as a material file cannot be read. Needs: files.
Result<ObjFiles> find_obj_files(std::span<const uint8_t> obj, const MeshSurroundings& beside);

}  // namespace burnish

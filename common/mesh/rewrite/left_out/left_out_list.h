#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/file_budget.h"
#include "common/mesh/rewrite/left_out/left_out.h"
#include "common/mesh/rewrite/packed_mesh.h"

namespace burnish {

/// Private to this folder: the names of attributes, each once.
class LeftOutList {
 public:
  void add(const std::string& name) {
    if (std::find(names_.begin(), names_.end(), name) != names_.end()) return;
    if (names_.size() < kLeftOutMax) names_.push_back(name);
    if (names_.size() == kLeftOutMax) names_.back() = "others";
  }
  void add_if(bool is_there, const std::string& name) {
    if (is_there) add(name);
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

/// Add what a file has besides positions, triangles and vertex colours. `triangles` are the mesh's.
/// Return false if the file is not in the format.
bool list_ply_extras(std::span<const uint8_t> bytes, size_t triangles, LeftOutList& list);
bool list_obj_extras(std::span<const uint8_t> bytes, size_t triangles, const FileSteps& steps,
                     LeftOutList& list);
bool list_gltf_extras(std::span<const uint8_t> bytes, LeftOutList& list);
/// Adds the files beside an archive's mesh, by their kinds.
void list_files_beside(const PackedMesh& packed, LeftOutList& list);

}  // namespace burnish

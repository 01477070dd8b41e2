#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/mesh/rewrite/left_out_list.h"
#include "common/mesh/rewrite/packed_mesh.h"

namespace burnish {

/// Private to this folder: adds the files beside an archive's mesh, by their kinds.
void list_files_beside(const PackedMesh& packed, LeftOutList& list);

}  // namespace burnish

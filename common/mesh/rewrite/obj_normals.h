#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/rewrite/moved/moved_normals.h"

namespace burnish {

inline constexpr TextSyntax kObjSyntax = {.hash_comments = true, .backslash_continues = true};

/// Returns the area vectors of the faces that refer to each `vn` of an OBJ file, in the file's
/// order; a face counts once for each of its corners. Those of one place that are equal share their
/// faces (share_areas()). Ignores references that lead nowhere.
std::vector<AreaVectors> gather_obj_normals(std::span<const uint8_t> bytes, const MovedMesh& moved,
                                            const FileSteps& steps);

}  // namespace burnish

#pragma once

#include "common/base/file_budget.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Does the same as without steps, which hear of each vertex and triangle. Throws: WorkCancelled.
Status validate(const MeshView& mesh, FileSteps steps);

}  // namespace burnish

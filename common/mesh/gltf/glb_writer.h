#pragma once

#include "common/base/status.h"
#include "common/mesh/output_buffer.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Writes everything to `output`. Needs: a valid mesh. Throws: WorkCancelled.
Status write_glb(const MeshView& mesh, OutputBuffer& output);

}  // namespace burnish

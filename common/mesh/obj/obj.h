#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/output_buffer.h"
#include "common/mesh/stored_mesh.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Reads an OBJ file as mesh_io.cpp asks of a reader. Fails: invalid_argument. Throws:
/// WorkCancelled.
Result<TriangleMesh> read_obj(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps = {});
/// Does the same; fills an empty mesh in scratch space.
Status read_obj(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh);

/// Writes everything to `output`. Needs: a valid mesh. Throws: WorkCancelled.
Status write_obj(const MeshView& mesh, OutputBuffer& output);

}  // namespace burnish

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/stored_mesh.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Reads an OFF file as mesh_io.cpp asks of a reader. Fails: invalid_argument. Throws:
/// WorkCancelled.
Result<TriangleMesh> read_off(std::span<const uint8_t> bytes, const std::string& name,
                              const FileSteps& steps = {});
/// Does the same; fills an empty mesh in scratch space.
Status read_off(std::span<const uint8_t> bytes, const std::string& name, const FileSteps& steps,
                GrowingMesh& mesh);

}  // namespace burnish

#pragma once

#include <cstdint>

#include "server/prepare/preparation_need.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns the bytes that a prepared mesh and its hierarchy will take together. Works before the
/// hierarchy is made.
uint64_t predict_mesh_bytes(const PreparedMesh& prepared);
uint64_t predict_mesh_bytes(const PreparedSummary& prepared);

/// Returns the bytes that a prepared mesh and one session over it will take at least. Works before
/// the mesh is prepared. Accuracy: no more than their opening is admitted with, so that nobody is
/// refused wrongly.
uint64_t predict_opened_bytes(const PreparationNeed& need);

}  // namespace burnish

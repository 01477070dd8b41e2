#pragma once

#include <cstdint>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/hierarchy.h"

namespace burnish {

/// Bytes that a prepared mesh and its hierarchy will take together, before the hierarchy is made.
uint64_t predict_mesh_bytes(const PreparedMesh& prepared);

/// Bytes that one session over the mesh will take for itself, before its solver is made.
/// Accuracy: no less than it takes on the CPU backend, and less than twice that from some ten
/// thousand corners on.
uint64_t predict_session_bytes(const Hierarchy& hierarchy);

}  // namespace burnish

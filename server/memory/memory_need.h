#pragma once

#include <cstdint>

#include "common/frame_codec/frame_layout.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Returns the bytes that one session over a mesh will take for itself, with a gesture's copy of
/// its fields. Works before the solver is made. Accuracy: no less than the session takes on the CPU
/// backend, and less than twice that from some ten thousand corners on.
uint64_t predict_session_bytes(const Multigrid& on);

/// Returns the bytes that all clients with the same drawn mesh will take for their frames' layout.
/// If the mesh is a proxy of at most `triangles_max` triangles, its points count too; 0 means the
/// whole scan.
uint64_t predict_target_bytes(const PreparedMesh& prepared, const Hierarchy& hierarchy,
                              uint64_t triangles_max);

/// Returns the bytes that a client's encoder will take for the frames that it remembers and one in
/// the making. Accuracy: no less than it takes while displacements are below 128 cells. Less than
/// twice what a client takes that acknowledges late.
uint64_t predict_client_bytes(const FrameLayout& layout);

/// Returns the bytes that are taken only while a proxy is made.
uint64_t predict_proxy_bytes(const PreparedMesh& prepared);

}  // namespace burnish

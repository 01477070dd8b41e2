#pragma once

#include <cstdint>

#include "common/frame_codec/frame_layout.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Bytes that one session over a mesh will take for itself, before its solver is made, with the
/// copy of its fields that a gesture works on.
/// Accuracy: no less than it takes on the CPU backend, and less than twice that from some ten
/// thousand corners on.
uint64_t predict_session_bytes(const Multigrid& on);

/// Bytes that the frames of clients which draw the same mesh will take for their layout and, where
/// that mesh is a proxy of at most so many triangles, for its points; 0: the whole scan.
uint64_t predict_target_bytes(const PreparedMesh& prepared, const Hierarchy& hierarchy,
                              uint64_t triangles_max);

/// Bytes that a client's encoder will take for the frames that it remembers, with one in the
/// making. Accuracy: no less than it takes while displacements are below 128 cells, and less than
/// twice that of a client that acknowledges late.
uint64_t predict_client_bytes(const FrameLayout& layout);

/// Bytes that are taken only while a proxy is made.
uint64_t predict_proxy_bytes(const PreparedMesh& prepared);

}  // namespace burnish

#pragma once

#include <cstdint>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

// The noises that filters are compared by. Deviations are over the mean edge of the triangles.
// Vertices at one place move alike, so that seams stay closed.

/// Moves each vertex along its normal by a number of its own: Gaussian within six deviations.
void add_white_noise(TriangleMesh& mesh, double deviation, uint64_t seed);

/// Adds what structured light leaves: noise along the normals that is alike over about three edges,
/// and depths in steps of twice its deviation along one view.
void add_structured_light_noise(TriangleMesh& mesh, double deviation, uint64_t seed);

/// Returns the mean length of the triangles' sides.
double mean_edge(const TriangleMesh& mesh);

}  // namespace burnish

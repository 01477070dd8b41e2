#pragma once

#include <cstdint>
#include <vector>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Noise that a range scanner adds to a surface: deviations along the normal, in the mesh's units.
struct ScannerNoise {
  double white = 0;       ///< independent from vertex to vertex
  double correlated = 0;  ///< smooth over correlation_length
  double correlation_length = 1;
};

/// Returns unit normals per vertex, weighted by area; zero for a vertex without a proper triangle.
std::vector<Vec3d> vertex_normals(const TriangleMesh& mesh);

/// Moves every vertex along its normal.
void add_scanner_noise(TriangleMesh& mesh, const ScannerNoise& noise, uint64_t seed);

/// Rounds each position to single precision, as a scanner's file does.
void round_to_float(TriangleMesh& mesh);

}  // namespace burnish

#pragma once

#include <cstdint>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

// One function per kind of generated scan. Each makes about `vertices` vertices; the seed decides
// everything else. Needs: counts within the kind's limits (generate.cpp). Float positions are
// already rounded to float.

TriangleMesh generate_tablet(uint64_t vertices, uint64_t seed);
TriangleMesh generate_blob(uint64_t vertices, uint64_t seed);
TriangleMesh generate_sheets(uint64_t vertices, uint64_t seed);
TriangleMesh generate_fan(uint64_t vertices, uint64_t seed);
TriangleMesh generate_soup(uint64_t vertices, uint64_t seed);
TriangleMesh generate_part(uint64_t vertices, uint64_t seed);
TriangleMesh generate_wall(uint64_t vertices, uint64_t seed);

/// Returns the distance of the blob's surface from its centre along a unit direction, about
/// 0.5..1.5.
double blob_radius(const Vec3d& direction, uint64_t seed);

}  // namespace burnish

#pragma once

#include <cstdint>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

// One function per kind of generated scan: about this many vertices, everything else from the
// seed. Counts are within the kind's limits (generate.cpp); float positions come out as floats.

TriangleMesh generate_tablet(uint64_t vertices, uint64_t seed);
TriangleMesh generate_blob(uint64_t vertices, uint64_t seed);
TriangleMesh generate_sheets(uint64_t vertices, uint64_t seed);
TriangleMesh generate_fan(uint64_t vertices, uint64_t seed);
TriangleMesh generate_soup(uint64_t vertices, uint64_t seed);
TriangleMesh generate_part(uint64_t vertices, uint64_t seed);

/// Distance of the blob's surface from its centre along a unit direction, in 0.5..1.5 or so.
double blob_radius(const Vec3d& direction, uint64_t seed);

}  // namespace burnish

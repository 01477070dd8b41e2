#pragma once

#include <cstdint>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A generated scan (common/generate/generate.h).
TriangleMesh scan_of_kind(const char* kind, uint64_t vertices);

/// Triangles that share no vertex, of random place and size, in the unit cube.
TriangleMesh loose_triangles(uint32_t count);

/// Random triangles between few vertices: each page has nearly all vertices.
TriangleMesh tangle(uint32_t vertices, uint32_t triangles);

/// Every triangle once more, and once more facing the other way.
TriangleMesh with_duplicates(TriangleMesh mesh);

/// Many tetrahedra, each closed and apart from the others.
TriangleMesh small_components(uint32_t count);

}  // namespace burnish

#pragma once

#include <cstdint>

#include "common/generate/generate.h"
#include "common/generate/scanner.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

// One function per kind of generated scan. Each makes about the wanted number of vertices; the seed
// decides everything else. generate_scan() adds the wanted noise to kinds that have none of their
// own. Needs: counts within the kind's limits (generate.cpp). Float positions are already rounded
// to float.

TriangleMesh generate_tablet(const GeneratedScan& wanted);
TriangleMesh generate_blob(const GeneratedScan& wanted);
TriangleMesh generate_sheets(const GeneratedScan& wanted);
TriangleMesh generate_fan(const GeneratedScan& wanted);
TriangleMesh generate_soup(const GeneratedScan& wanted);
TriangleMesh generate_part(const GeneratedScan& wanted);
TriangleMesh generate_coin(const GeneratedScan& wanted);
TriangleMesh generate_wall(const GeneratedScan& wanted);

/// Returns the noise that the scan says, in the mesh's units, or the kind's own.
ScannerNoise wanted_noise(const TriangleMesh& mesh, const GeneratedScan& wanted,
                          const ScannerNoise& own);

/// Returns the distance of the blob's surface from its centre along a unit direction, about
/// 0.5..1.5.
double blob_radius(const Vec3d& direction, uint64_t seed);

}  // namespace burnish

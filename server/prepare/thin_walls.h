#pragma once

#include <span>

#include "common/base/heard_loop.h"
#include "common/mesh/statistics/thin_walls.h"
#include "server/prepare/surface.h"

namespace burnish {

/// Looks from up to 1024 places, spread evenly over the area, up to a cell into the surface. A
/// place lies on a thin wall if something there faces away from it. `area` is the surface's in grid
/// units; the normals of a mesh inside out point into it. Needs: pieces by cell. Accuracy: the
/// share has a standard error of 0.016 at most, of 0.031 for fewer than 32,000 triangles.
/// Deterministic. Cost: below 3 % of a preparation. Throws: WorkCancelled.
ThinWalls find_thin_walls(const Surface& surface, std::span<const CellPiece> pieces, double area,
                          bool is_inside_out, const LoopPart& part = kUnheardLoop);

}  // namespace burnish

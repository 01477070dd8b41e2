#pragma once

#include <span>

#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Both curvatures of every cell, weighted by its area; the range holds 99.5 % of the area.
CurvatureHistogram make_histogram(std::span<const CellCurvature> curvature);

}  // namespace burnish

#pragma once

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Splits every triangle in four. A new vertex lies on the curve that leaves both ends of its edge
/// along their tangent planes, so the surface becomes smoother and gets no detail. Old vertices
/// stay. Colours are lost. Needs: a valid mesh.
TriangleMesh refined_mesh(const TriangleMesh& mesh);

}  // namespace burnish

#pragma once

#include <string>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/textures/surface_textures.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Gives each vertex a colour: the mean of the texels that it owns, the third of each of its
/// triangles that is nearest to it, in linear light. Vertices that look alike
/// at one place (common/mesh/agreeing_vertices.h) share them. A vertex without triangles is white.
/// One colour for all vertices counts as none, unless the pictures have detail. If the mesh has
/// colours, multiplies them in linear light. Textures of another number of triangles colour
/// nothing. Needs: valid indices.
///
/// A triangle has the plain colour of its material where a coordinate is missing, not finite or
/// above kTextureCoordinateMax, where the picture is neither PNG, JPEG nor WebP, and where it is
/// beyond kTexturePicturesMax pictures or kTexelsMax texels. A picture is decoded row by row and
/// never kept. `budget` hears the memory of the decoder, and of what a scan takes beside it: about
/// 100 bytes a triangle. `name` is for messages.
///
/// Fails: as a picture cannot be read, if the textures refuse damage; as `budget` does.
Status add_texture_colours(TriangleMesh& mesh, const SurfaceTextures& textures,
                           const FileBudget& budget, const std::string& name);

}  // namespace burnish

#pragma once

#include "client/camera.h"
#include "client/image.h"
#include "client/view_mesh.h"
#include "common/base/status.h"

namespace burnish {

struct DrawStyle {
  bool flat = false;       ///< one normal per triangle
  bool wireframe = false;  ///< the triangles' edges on top
};

/// What draws a mesh: OpenGL (client/gl), or nothing (NullRenderer) where pictures do not matter.
/// Used from one thread.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Replaces the mesh that is drawn. Fails: resource_exhausted; then nothing is drawn.
  virtual Status upload_mesh(const ViewMesh& mesh) = 0;

  /// Draws the mesh, if there is one, before the background.
  /// Fails: invalid_argument (size), resource_exhausted.
  virtual Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) = 0;

  /// The last drawn picture. Fails: failed_precondition before the first draw().
  virtual Result<Image> read_pixels() = 0;
};

}  // namespace burnish

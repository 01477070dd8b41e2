#pragma once

#include <optional>
#include <span>

#include "client/scene/camera.h"
#include "client/scene/draw_style.h"
#include "client/scene/image.h"
#include "client/scene/view_mesh.h"
#include "common/base/status.h"

namespace burnish {

/// Elements first..first+count of an array.
struct IndexRange {
  size_t first = 0;
  size_t count = 0;
};

/// Draws a mesh: with OpenGL (client/gl), or without pictures (NullRenderer). Used from one thread.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Replaces the drawn mesh, without displacements, values or tints.
  /// Fails: resource_exhausted; then nothing is drawn.
  virtual Status upload_mesh(const ViewMesh& mesh) = 0;

  /// Moves the surface. Shapes: one per corner of the mesh's grid; only the changed ranges are
  /// read. Units: cells. Needs: a mesh that has a grid.
  virtual Status upload_displacements(std::span<const Vec3f> displacements,
                                      std::span<const IndexRange> changed) = 0;

  /// Sets the values that Colouring::kCells shows. Shapes: one per cell. Units: -1 to 1.
  virtual Status upload_cell_values(std::span<const float> values) = 0;

  /// Sets how strongly cells show DrawStyle::tint. Shapes: one per cell. Units: 0 to 1.
  virtual Status upload_cell_tint(std::span<const float> weights, IndexRange changed) = 0;

  /// Draws the mesh, if there is one, in front of the background.
  /// Fails: invalid_argument (size), resource_exhausted.
  virtual Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) = 0;

  /// Returns the last drawn picture. Fails: failed_precondition before the first draw().
  virtual Result<Image> read_pixels() = 0;

  /// Returns the triangle at the middle of a pixel, if any, on the displaced or on the original
  /// surface.
  virtual Result<std::optional<uint32_t>> pick(const Camera& camera, const ImageSize& size,
                                               const Eigen::Vector2i& pixel, bool original) = 0;
};

}  // namespace burnish

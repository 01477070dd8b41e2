#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "client/scene/camera.h"
#include "client/scene/image.h"
#include "client/scene/view_mesh.h"
#include "common/base/status.h"

namespace burnish {

/// The meaning of the surface's colour.
enum class Colouring {
  kClay,          ///< only the shape
  kCells,         ///< the values of upload_cell_values(): blue at -1, red at 1
  kDisplacement,  ///< movement along the normal: blue inwards, red outwards
  kScan,          ///< the scan's own colours, of pages alone
};

/// A brush's outline: all points of the original surface at this distance from its centre, drawn at
/// their displaced places. It is round on the original surface and bends with edits, so that the
/// brush changes exactly what lies inside.
struct Ring {
  Vec3d centre = Vec3d::Zero();  ///< file units, on the original surface
  double radius = 0;             ///< file units
  Vec3f colour = Vec3f::Ones();  ///< sRGB

  bool operator==(const Ring&) const = default;
};

inline constexpr size_t kRingsDrawnMax = 8;

struct DrawStyle {
  bool flat = false;       ///< one normal per triangle
  bool wireframe = false;  ///< edges of triangles on top
  Colouring colouring = Colouring::kClay;
  double displacement_range = 1;  ///< cells; full blue and full red
  bool original = false;          ///< shows the surface without displacements
  double split = 0;               ///< left part of the width that shows the original
  bool faded = false;             ///< grey: the picture may be out of date
  std::vector<Ring> rings;        ///< at most kRingsDrawnMax are drawn
  Vec3f tint = Vec3f::Ones();     ///< sRGB, for cells of upload_cell_tint()

  bool operator==(const DrawStyle&) const = default;
};

/// Returns the first column that shows the edited surface under DrawStyle::split.
inline int split_column(double split, int width) {
  return static_cast<int>(std::lround(std::clamp(split, 0.0, 1.0) * width));
}

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

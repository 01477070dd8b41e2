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

/// What the surface's colour tells.
enum class Colouring {
  kClay,          ///< nothing but its shape
  kCells,         ///< the values of upload_cell_values(): blue at -1, red at 1
  kDisplacement,  ///< how far it moved along its normal: blue inwards, red outwards
};

/// A brush's outline: all points of the original surface at this distance of its centre, wherever
/// they are now. Round on the surface as it was; as bent as the surface is where edits stretched
/// it, so that the brush changes what lies inside, and nothing else.
struct Ring {
  Vec3d centre = Vec3d::Zero();  ///< file units, on the original surface
  double radius = 0;             ///< file units
  Vec3f colour = Vec3f::Ones();  ///< sRGB

  bool operator==(const Ring&) const = default;
};

inline constexpr size_t kRingsDrawnMax = 8;

struct DrawStyle {
  bool flat = false;       ///< one normal per triangle
  bool wireframe = false;  ///< the triangles' edges on top
  Colouring colouring = Colouring::kClay;
  double displacement_range = 1;  ///< cells; what is full blue and full red
  bool original = false;          ///< as if nothing had moved
  double split = 0;               ///< the part of the width, from the left, that shows the original
  bool faded = false;             ///< grey: what is shown may be out of date
  std::vector<Ring> rings;        ///< kRingsDrawnMax are drawn
  Vec3f tint = Vec3f::Ones();     ///< sRGB, where upload_cell_tint() says so

  bool operator==(const DrawStyle&) const = default;
};

/// The first column that DrawStyle::split leaves to the surface as it is.
inline int split_column(double split, int width) {
  return static_cast<int>(std::lround(std::clamp(split, 0.0, 1.0) * width));
}

/// Elements first..first+count of an array.
struct IndexRange {
  size_t first = 0;
  size_t count = 0;
};

/// What draws a mesh: OpenGL (client/gl), or nothing (NullRenderer) where pictures do not matter.
/// Used from one thread.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// Replaces the mesh that is drawn; nothing is displaced, no cell has a value or a tint.
  /// Fails: resource_exhausted; then nothing is drawn.
  virtual Status upload_mesh(const ViewMesh& mesh) = 0;

  /// Moves the surface. Shapes: one per corner of the mesh's grid, of which the changed ranges are
  /// read. Units: cells. Needs: a mesh that has a grid.
  virtual Status upload_displacements(std::span<const Vec3f> displacements,
                                      std::span<const IndexRange> changed) = 0;

  /// What Colouring::kCells shows. Shapes: one per cell. Units: -1 to 1.
  virtual Status upload_cell_values(std::span<const float> values) = 0;

  /// How strongly cells show DrawStyle::tint. Shapes: one per cell. Units: 0 to 1.
  virtual Status upload_cell_tint(std::span<const float> weights, IndexRange changed) = 0;

  /// Draws the mesh, if there is one, before the background.
  /// Fails: invalid_argument (size), resource_exhausted.
  virtual Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) = 0;

  /// The last drawn picture. Fails: failed_precondition before the first draw().
  virtual Result<Image> read_pixels() = 0;

  /// The triangle that the middle of a pixel shows, if any, as the surface lies now, or as though
  /// nothing had moved.
  virtual Result<std::optional<uint32_t>> pick(const Camera& camera, const ImageSize& size,
                                               const Eigen::Vector2i& pixel, bool original) = 0;
};

}  // namespace burnish

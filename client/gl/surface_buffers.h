#pragma once

#include <span>
#include <vector>

#include "client/gl/texture_buffer.h"
#include "client/scene/renderer.h"

namespace burnish {

/// Data that moves and colours a mesh on the graphics card: the corners of each cell, the
/// displacement of each corner, a value and a tint of each cell. Needs: a current context for its
/// whole life.
class SurfaceBuffers {
 public:
  SurfaceBuffers();

  /// Starts without displacements and values. Fails: resource_exhausted.
  Status upload(const ViewMesh& mesh);

  // Work as Renderer's functions of these names.
  Status upload_displacements(std::span<const Vec3f> displacements,
                              std::span<const IndexRange> changed);
  Status upload_cell_values(std::span<const float> values);
  Status upload_cell_tint(std::span<const float> weights, IndexRange changed);

  /// Binds all buffers to the texture units of SurfaceUnit.
  void bind() const;

 private:
  TextureBuffer cell_corners_;
  TextureBuffer displacements_;
  TextureBuffer cell_values_;
  TextureBuffer cell_tint_;
  std::vector<Eigen::Vector4f> padded_;  // one range; texels of three floats need OpenGL 4
};

/// Texture units that the shaders use.
enum SurfaceUnit { kCellCornersUnit, kDisplacementsUnit, kCellValuesUnit, kCellTintUnit };

}  // namespace burnish

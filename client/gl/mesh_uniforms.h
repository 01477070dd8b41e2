#pragma once

#include "client/gl/shader_program.h"
#include "client/scene/renderer.h"

namespace burnish {

/// Where a mesh lies and how large its units are: all that placing it needs.
struct MeshPlace {
  Vec3d centre = Vec3d::Zero();  ///< file units
  double unit = 1;               ///< half the diagonal, file units
  float cell_size = 0;           ///< half diagonals
  bool has_grid = false;
};

/// Sets what the mesh's vertex shader needs. `clip` follows the projection.
void set_place(const ShaderProgram& program, const MeshPlace& place, const Camera& camera,
               double aspect, bool original,
               const Eigen::Matrix4d& clip = Eigen::Matrix4d::Identity());

/// Sets what the mesh's fragment shader needs.
void set_style(const ShaderProgram& program, const MeshPlace& place, const DrawStyle& style);

}  // namespace burnish

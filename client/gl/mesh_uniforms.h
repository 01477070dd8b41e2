#pragma once

#include "client/gl/shader_program.h"
#include "client/scene/camera.h"
#include "client/scene/draw_style.h"

namespace burnish {

/// The place and the units of a mesh.
struct MeshPlace {
  Vec3d centre = Vec3d::Zero();  ///< file units
  double unit = 1;               ///< half the diagonal, file units
  float cell_size = 0;           ///< half diagonals
  bool has_grid = false;
};

/// Sets the uniforms of the mesh's vertex shader. `clip` is applied after the projection.
void set_place(const ShaderProgram& program, const MeshPlace& place, const Camera& camera,
               double aspect, bool original,
               const Eigen::Matrix4d& clip = Eigen::Matrix4d::Identity());

/// Sets the uniforms of the mesh's fragment shader.
void set_style(const ShaderProgram& program, const MeshPlace& place, const DrawStyle& style);

}  // namespace burnish

#include "client/gl/page_uniforms.h"

#include <algorithm>
#include <string>

namespace burnish {

// Returns the matrix to camera space in the units of PageSpace, so that floats suffice for any file
// unit.
static Eigen::Matrix4d model_view(const PageSpace& space, const Camera& camera) {
  Eigen::Matrix4d centre = Eigen::Matrix4d::Identity();
  centre.topRightCorner<3, 1>() = space.centre;
  Eigen::Matrix4d seen = view_matrix(camera) * centre;
  seen.topRightCorner<3, 1>() /= space.unit;
  return seen;
}

void set_place(const ShaderProgram& program, const PageSpace& space, const Camera& camera,
               double aspect, bool original) {
  Camera scaled = camera;
  scaled.distance /= space.unit;
  scaled.scene_radius /= space.unit;
  const Eigen::Matrix4d projection = projection_matrix(scaled, aspect);
  program.set("model_view", Eigen::Matrix4f(model_view(space, camera).cast<float>()));
  program.set("projection", Eigen::Matrix4f(projection.cast<float>()));
  program.set("cell_size", original ? 0.0f : space.cell_size);
}

static void set_rings(const ShaderProgram& program, const PageSpace& space,
                      const std::vector<Ring>& rings) {
  const size_t count = std::min(rings.size(), kRingsDrawnMax);
  program.set("ring_count", static_cast<int>(count));
  for (size_t i = 0; i < count; ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    Eigen::Vector4f ring;
    ring.head<3>() = ((rings[i].centre - space.centre) / space.unit).cast<float>();
    ring.w() = static_cast<float>(rings[i].radius / space.unit);
    program.set(("rings" + index).c_str(), ring);
    program.set(("ring_colours" + index).c_str(), rings[i].colour);
  }
}

void set_style(const ShaderProgram& program, const PageSpace& space, const DrawStyle& style) {
  program.set("flat_normals", style.flat);
  program.set("edges", false);
  program.set("faded", style.faded);
  program.set("colouring", static_cast<int>(style.colouring));
  program.set("displacement_range", static_cast<float>(style.displacement_range));
  program.set("tint_colour", style.tint);
  set_rings(program, space, style.rings);
}

}  // namespace burnish

#include "client/gl/page_uniforms.h"

#include <algorithm>
#include <string>

namespace burnish {

// Returns the matrix to camera space in the units of PageSpace.
static Eigen::Matrix4d model_view(const PageSpace& space, const Camera& camera) {
  Eigen::Matrix4d centre = Eigen::Matrix4d::Identity();
  centre.topRightCorner<3, 1>() = space.centre;
  Eigen::Matrix4d seen = view_matrix(camera) * centre;
  seen.topRightCorner<3, 1>() /= space.unit;
  return seen;
}

Camera in_units(const PageSpace& space, Camera camera) {
  camera.distance /= space.unit;
  camera.scene_radius /= space.unit;
  return camera;
}

void set_place(const ShaderProgram& program, const PageSpace& space, const Camera& camera,
               double aspect, bool original) {
  const Eigen::Matrix4d projection = projection_matrix(in_units(space, camera), aspect);
  program.set("model_view", Eigen::Matrix4f(model_view(space, camera).cast<float>()));
  program.set("projection", Eigen::Matrix4f(projection.cast<float>()));
  program.set("parallel", camera.orthographic);
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

static void set_light(const ShaderProgram& program, const Lighting& lighting) {
  program.set("light_kind", static_cast<int>(lighting.kind));
  program.set("to_lamp", to_lamp(lighting));
  program.set("specular", static_cast<float>(lighting.specular));
}

void set_style(const ShaderProgram& program, const PageSpace& space, const DrawStyle& style) {
  program.set("flat_normals", style.flat);
  program.set("edges", false);
  program.set("faded", style.faded);
  program.set("colouring", static_cast<int>(style.colouring));
  const ColourEnds& ends = style.displacement;
  program.set("displacement_ends", Eigen::Vector2d(ends.low, ends.high).cast<float>().eval());
  program.set("tint_colour", style.tint);
  set_light(program, style.lighting);
  set_rings(program, space, style.rings);
}

}  // namespace burnish

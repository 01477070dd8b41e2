#include "client/gl/mesh_uniforms.h"

#include <algorithm>
#include <string>

#include "client/gl/surface_buffers.h"

namespace burnish {

// Returns the matrix to camera space in units of the mesh's half diagonal, so that floats suffice
// for any file unit.
static Eigen::Matrix4d model_view(const MeshPlace& place, const Camera& camera) {
  Eigen::Matrix4d centre = Eigen::Matrix4d::Identity();
  centre.topRightCorner<3, 1>() = place.centre;
  Eigen::Matrix4d seen = view_matrix(camera) * centre;
  seen.topRightCorner<3, 1>() /= place.unit;
  return seen;
}

void set_place(const ShaderProgram& program, const MeshPlace& place, const Camera& camera,
               double aspect, bool original, const Eigen::Matrix4d& clip) {
  Camera scaled = camera;
  scaled.distance /= place.unit;
  scaled.scene_radius /= place.unit;
  const Eigen::Matrix4d projection = clip * projection_matrix(scaled, aspect);
  program.set("model_view", Eigen::Matrix4f(model_view(place, camera).cast<float>()));
  program.set("projection", Eigen::Matrix4f(projection.cast<float>()));
  program.set("has_grid", place.has_grid);
  program.set("cell_size", original ? 0.0f : place.cell_size);
  program.set("cell_corners", int{kCellCornersUnit});
  program.set("displacements", int{kDisplacementsUnit});
  program.set("cell_values", int{kCellValuesUnit});
  program.set("cell_tint", int{kCellTintUnit});
}

static void set_rings(const ShaderProgram& program, const MeshPlace& place,
                      const std::vector<Ring>& rings) {
  const size_t count = std::min(rings.size(), kRingsDrawnMax);
  program.set("ring_count", static_cast<int>(count));
  for (size_t i = 0; i < count; ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    Eigen::Vector4f ring;
    ring.head<3>() = ((rings[i].centre - place.centre) / place.unit).cast<float>();
    ring.w() = static_cast<float>(rings[i].radius / place.unit);
    program.set(("rings" + index).c_str(), ring);
    program.set(("ring_colours" + index).c_str(), rings[i].colour);
  }
}

void set_style(const ShaderProgram& program, const MeshPlace& place, const DrawStyle& style) {
  program.set("flat_normals", style.flat);
  program.set("edges", false);
  program.set("faded", style.faded);
  program.set("colouring", static_cast<int>(style.colouring));
  program.set("displacement_range", static_cast<float>(style.displacement_range));
  program.set("tint_colour", style.tint);
  set_rings(program, place, style.rings);
}

}  // namespace burnish

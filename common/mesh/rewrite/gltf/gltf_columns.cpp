#include "common/mesh/rewrite/gltf/gltf_columns.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <Eigen/Geometry>

#include "common/mesh/rewrite/gltf/gltf_normals.h"

namespace burnish {

static Vec3f element_of(const GltfAccessor& accessor, uint64_t i) {
  return {accessor.number(i, 0), accessor.number(i, 1), accessor.number(i, 2)};
}

static GltfColumn unmoved_column(size_t points, const GltfAccessor& accessor) {
  GltfColumn column{points, accessor, {}};
  column.values.reserve(accessor.count);
  for (uint64_t i = 0; i < accessor.count; ++i) column.values.push_back(element_of(accessor, i));
  return column;
}

/// Returns where a float position of a node goes. Rounds towards its place where it would else pass
/// the cap in the scene.
static Vec3f moved_position(const Vec3f& before, const Vec3d& shift,
                            const Eigen::Matrix3d& to_scene, double cap) {
  Vec3f after = (before.cast<double>() + shift).cast<float>();
  if (!(cap > 0) || (to_scene * (after - before).cast<double>()).norm() <= cap) return after;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(double{after[axis]} - before[axis]) > std::abs(shift[axis]))
      after[axis] = std::nextafter(after[axis], before[axis]);
  return after;
}

/// Moves a column's positions. Sets where the changed ones now are in the scene.
static void move_positions(const GltfPoints& points, const GltfPlacement& placed,
                           const MovedMesh& moved, GltfColumn& column,
                           std::vector<Vec3d>& positions_after) {
  const Eigen::Matrix3d to_node = placed.to_scene.linear().inverse();
  for (uint64_t i = 0; i < column.values.size(); ++i) {
    const uint32_t v = points.vertices[i];
    if (v == kNoVertex) continue;
    const Vec3d shift = moved.after.vertices[v] - moved.before[v];
    if (shift == Vec3d::Zero()) continue;
    const Vec3f value =
        moved_position(column.values[i], to_node * shift, placed.to_scene.linear(), moved.cap);
    if (value == column.values[i]) continue;
    column.values[i] = value;
    column.is_changed = true;
    positions_after[v] = placed.to_scene * value.cast<double>();
  }
}

bool GltfColumns::is_changed() const {
  return std::ranges::any_of(all, &GltfColumn::is_changed);
}

GltfColumns move_columns(const GltfSurface& surface, const MovedMesh& moved) {
  GltfColumns columns;
  std::vector<Vec3d> after(moved.before.begin(), moved.before.end());
  for (size_t p = 0; p < surface.points.size(); ++p) {
    const GltfPoints& points = surface.points[p];
    columns.all.push_back(unmoved_column(p, points.positions));
    move_positions(points, surface.placements[points.placement], moved, columns.all.back(), after);
  }
  std::map<std::tuple<size_t, uint64_t, uint64_t>, size_t> normals;  // by points and accessor
  for (const GltfPart& part : surface.parts) {
    columns.positions.push_back(part.points);
    const GltfAccessor* accessor = part.primitive->find("NORMAL");
    columns.normals.emplace_back();
    if (accessor == nullptr) continue;
    const uint64_t own = part.primitive->is_draco ? part.primitive->number : kNoAccessor;
    const auto [found, is_new] =
        normals.try_emplace({part.points, accessor->index, own}, columns.all.size());
    if (is_new) columns.all.push_back(unmoved_column(part.points, *accessor));
    columns.normals.back() = found->second;
  }
  if (columns.is_changed()) turn_normals(surface, moved.before, after, columns);
  return columns;
}

}  // namespace burnish

#include "client/raster/raster_page.h"

#include <cmath>

namespace burnish {

static constexpr float kNormalSteps = 32767;

RasterNormal raster_normal(const Vec3f& normal, float ridge) {
  const auto steps = [](float part) {
    return static_cast<int16_t>(std::lround(std::clamp(part, -1.0f, 1.0f) * kNormalSteps));
  };
  return {steps(normal.x()), steps(normal.y()), steps(normal.z()), steps(ridge)};
}

static Eigen::AlignedBox3f box_of(std::span<const Vec3f> positions) {
  Eigen::AlignedBox3f box;
  for (const Vec3f& position : positions) box.extend(position);
  return box;
}

static std::vector<Eigen::AlignedBox3f> boxes_of_runs(std::span<const Vec3f> positions,
                                                      std::span<const PageTriangle> triangles) {
  std::vector<Eigen::AlignedBox3f> boxes((triangles.size() + kRunTriangles - 1) / kRunTriangles);
  for (size_t t = 0; t < triangles.size(); ++t)
    for (const uint16_t corner : triangles[t]) boxes[t / kRunTriangles].extend(positions[corner]);
  return boxes;
}

static Vec3f sum_of(std::span<const Vec3f> normals) {
  Vec3f sum = Vec3f::Zero();
  for (const Vec3f& normal : normals) sum += normal;
  return sum;
}

static std::vector<RasterNormal> raster_normals(std::span<const Vec3f> normals,
                                                std::span<const float> ridges) {
  std::vector<RasterNormal> made(normals.size());
  for (size_t v = 0; v < made.size(); ++v) made[v] = raster_normal(normals[v], ridges[v]);
  return made;
}

void RasterPage::put(const PageMesh& mesh) {
  *this = {};
  original = {mesh.positions, raster_normals(mesh.normals, mesh.ridges), box_of(mesh.positions),
              boxes_of_runs(mesh.positions, mesh.triangles), sum_of(mesh.normals)};
  original_colours = mesh.colours;
  triangles = mesh.triangles;
}

void RasterPage::move(std::span<const Vec3f> displacements, std::span<const Vec3f> normals,
                      std::span<const float> ridges, float cell_size) {
  moved.positions.resize(displacements.size());
  along_normal.resize(displacements.size());
  for (size_t v = 0; v < displacements.size(); ++v) {
    const RasterNormal& still = original.normals[v];
    moved.positions[v] = original.positions[v] + cell_size * displacements[v];
    along_normal[v] = displacements[v].dot(Vec3f(still.x, still.y, still.z)) / kNormalSteps;
  }
  moved.normals = raster_normals(normals, ridges);
  moved.box = box_of(moved.positions);
  moved.run_boxes = boxes_of_runs(moved.positions, triangles);
  moved.mean_normal = sum_of(normals);
}

}  // namespace burnish

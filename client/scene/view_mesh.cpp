#include "client/scene/view_mesh.h"

#include <cmath>

namespace burnish {

static constexpr int kRidgeAveragingPasses = 2;
static constexpr float kRidgeCurvature = 60;  // per half diagonal; gives a ridge of 0.5

static Eigen::AlignedBox3d referenced_box(std::span<const Vec3d> vertices,
                                          std::span<const Triangle> triangles) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : triangles)
    for (uint32_t v : triangle) box.extend(vertices[v]);
  return box;
}

static void add_weighted_normal(std::span<const Vec3d> vertices, const Triangle& triangle,
                                std::span<Vec3d> sums) {
  const Vec3d& a = vertices[triangle[0]];
  const Vec3d normal =
      (vertices[triangle[1]] - a).cross(vertices[triangle[2]] - a).stableNormalized();
  for (int corner = 0; corner < 3; ++corner) {
    const Vec3d& at = vertices[triangle[corner]];
    const Vec3d to_next = (vertices[triangle[(corner + 1) % 3]] - at).stableNormalized();
    const Vec3d to_last = (vertices[triangle[(corner + 2) % 3]] - at).stableNormalized();
    const double angle = std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
    sums[triangle[corner]] += angle * normal;
  }
}

std::vector<Vec3f> vertex_normals(std::span<const Vec3d> vertices,
                                  std::span<const Triangle> triangles) {
  std::vector<Vec3d> sums(vertices.size(), Vec3d::Zero());
  for (const Triangle& triangle : triangles) add_weighted_normal(vertices, triangle, sums);
  std::vector<Vec3f> normals(vertices.size(), Vec3f::UnitZ());
  for (size_t v = 0; v < sums.size(); ++v) {
    const double length = sums[v].norm();
    if (length > 0) normals[v] = (sums[v] / length).cast<float>();
  }
  return normals;
}

struct Weighted {
  float value;
  float weight;
};

// Returns at each vertex Σ value / Σ weight of its edges, or 0 if no edge has weight.
template <typename EdgeValue>
static std::vector<float> mean_over_edges(size_t vertex_count, std::span<const Triangle> triangles,
                                          const EdgeValue& edge_value) {
  std::vector<Weighted> sums(vertex_count, Weighted{0, 0});
  const auto add = [&](uint32_t from, uint32_t to) {
    const Weighted term = edge_value(from, to);
    sums[from].value += term.value;
    sums[from].weight += term.weight;
  };
  for (const Triangle& triangle : triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      add(triangle[corner], triangle[(corner + 1) % 3]);
      add(triangle[(corner + 1) % 3], triangle[corner]);
    }
  }
  std::vector<float> means(vertex_count);
  for (size_t v = 0; v < vertex_count; ++v)
    if (sums[v].weight > 0) means[v] = sums[v].value / sums[v].weight;
  return means;
}

std::vector<float> vertex_ridges(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                                 std::span<const Triangle> triangles) {
  // Weights by squared length; otherwise the shortest edges of slivers would decide.
  std::vector<float> ridges =
      mean_over_edges(positions.size(), triangles, [&](uint32_t from, uint32_t to) {
        const Vec3f edge = positions[to] - positions[from];
        return Weighted{(normals[to] - normals[from]).dot(edge), edge.squaredNorm()};
      });
  for (int pass = 0; pass < kRidgeAveragingPasses; ++pass) {
    ridges = mean_over_edges(positions.size(), triangles, [&](uint32_t from, uint32_t to) {
      return Weighted{ridges[from] + ridges[to], 2};
    });
  }
  for (float& ridge : ridges) ridge /= kRidgeCurvature + std::abs(ridge);
  return ridges;
}

static ViewMesh make_drawn(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  ViewMesh view;
  view.box = referenced_box(vertices, triangles);
  view.positions.reserve(vertices.size());
  const Vec3d centre = view.box.center();
  const double unit = view.unit();
  for (const Vec3d& vertex : vertices)
    view.positions.push_back(((vertex - centre) / unit).cast<float>());
  view.normals = vertex_normals(vertices, triangles);
  view.ridges = vertex_ridges(view.positions, view.normals, triangles);
  view.triangles.assign(triangles.begin(), triangles.end());
  return view;
}

ViewMesh make_view_mesh(const TriangleMesh& mesh) {
  return make_drawn(mesh.vertices, mesh.triangles);
}

ViewMesh make_view_mesh(const View& view) {
  ViewMesh mesh = make_drawn(view.vertices, view.triangles);
  mesh.points = view.points;
  mesh.cell_corners = view.grid.cell_corners;
  mesh.corner_count = view.grid.corner_count();
  mesh.cell_size = static_cast<float>(view.frame.cell_size / mesh.unit());
  return mesh;
}

}  // namespace burnish

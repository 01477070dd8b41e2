#pragma once

#include <algorithm>

#include "common/evaluation/evaluation.h"
#include "common/mesh/statistics.h"
#include "common/view/view.h"
#include "tests/client/scene/sphere.h"

namespace burnish {

/// Makes the view of a mesh in its own grid, as a server would send it.
inline View make_gridded_view(const TriangleMesh& mesh, int depth) {
  const MeshStatistics statistics = compute_statistics(mesh);
  View view;
  view.frame = make_grid_frame(statistics.box_min, statistics.box_max, depth);
  view.length_unit = std::sqrt(statistics.area);
  std::vector<MortonKey> cells;
  for (const Triangle& triangle : mesh.triangles) {  // all cells that the box of a triangle touches
    Eigen::AlignedBox3d box;
    for (uint32_t v : triangle) box.extend(view.frame.to_grid(mesh.vertices[v]));
    const Vec3i low = box.min().array().floor().cast<int>();
    const Vec3i high = box.max().array().floor().cast<int>();
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) cells.push_back(morton_key({i, j, k}));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  view.grid = make_finest_grid(depth, cells);
  view.vertices = mesh.vertices;
  view.triangles = mesh.triangles;
  view.points = make_evaluation(mesh, view.frame, view.grid);
  view.scan_vertices = view.vertices.size();
  view.scan_triangles = view.triangles.size();
  return view;
}

inline View make_sphere_view(int depth = 4) {
  return make_gridded_view(make_test_sphere(Vec3d(3, -2, 1), 1), depth);
}

}  // namespace burnish

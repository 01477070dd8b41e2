#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "client/scene/mesh_normals.h"
#include "common/grid/grid.h"
#include "common/mesh/statistics/statistics.h"
#include "common/pages/page.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// A mesh cut into pages of level 0.
struct SplitMesh {
  PageGrid grid;
  TriangleMesh rounded;                          ///< the mesh with its vertices on the lattice
  std::vector<Page> pages;                       ///< in the order of kd halves
  std::vector<std::vector<uint32_t>> vertices;   ///< per page: its vertices in the mesh
  std::vector<std::vector<uint32_t>> triangles;  ///< per page: its triangles in the mesh
};

namespace page_splitter {

using Faces = std::vector<uint32_t>;

// Splits across the longest side of the centroids' box at the median.
inline std::pair<Faces, Faces> halves(const TriangleMesh& mesh, Faces faces) {
  const auto centroid = [&](uint32_t face) {
    const Triangle& t = mesh.triangles[face];
    return Vec3d((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3);
  };
  Eigen::AlignedBox3d box;
  for (const uint32_t face : faces) box.extend(centroid(face));
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle = faces.begin() + static_cast<ptrdiff_t>(faces.size() / 2);
  std::nth_element(faces.begin(), middle, faces.end(), [&](uint32_t a, uint32_t b) {
    return std::pair(centroid(a)[axis], a) < std::pair(centroid(b)[axis], b);
  });
  return {Faces(faces.begin(), middle), Faces(middle, faces.end())};
}

inline void split(const TriangleMesh& mesh, Faces faces, size_t triangles_max,
                  std::vector<Faces>& pages) {
  if (faces.size() <= triangles_max) {
    std::sort(faces.begin(), faces.end());
    pages.push_back(std::move(faces));
    return;
  }
  const auto [low, high] = halves(mesh, std::move(faces));
  split(mesh, low, triangles_max, pages);
  split(mesh, high, triangles_max, pages);
}

inline std::vector<int> pages_of_vertices(const TriangleMesh& mesh,
                                          const std::vector<Faces>& pages) {
  std::vector<int> count(mesh.vertices.size());
  for (const Faces& faces : pages) {
    std::vector<uint8_t> is_used(mesh.vertices.size());
    for (const uint32_t face : faces)
      for (const uint32_t v : mesh.triangles[face])
        if (!std::exchange(is_used[v], 1)) ++count[v];
  }
  return count;
}

// Border vertices come first.
inline std::vector<uint32_t> page_vertices(const TriangleMesh& mesh, const Faces& faces,
                                           const std::vector<int>& page_count) {
  std::vector<uint32_t> vertices;
  for (const uint32_t face : faces)
    vertices.insert(vertices.end(), mesh.triangles[face].begin(), mesh.triangles[face].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::stable_partition(vertices.begin(), vertices.end(),
                        [&](uint32_t v) { return page_count[v] > 1; });
  return vertices;
}

inline Page make_page(const SplitMesh& split, size_t number, const std::vector<int>& page_count,
                      const std::vector<Vec3f>& normals) {
  const std::vector<uint32_t>& vertices = split.vertices[number];
  Page page;
  page.id = static_cast<PageId>(number);
  std::map<uint32_t, uint16_t> place;
  for (const uint32_t v : vertices) {
    place[v] = static_cast<uint16_t>(page.positions.size());
    page.positions.push_back(split.grid.quantise(split.rounded.vertices[v]));
    if (split.rounded.has_colours()) page.colours.push_back(split.rounded.colours[v]);
    if (page_count[v] < 2) continue;
    page.normals.push_back(normals[v]);
    ++page.border_vertices;
  }
  for (const uint32_t face : split.triangles[number]) {
    const Triangle& t = split.rounded.triangles[face];
    page.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
  }
  page.patches = {{kNoPage, static_cast<uint32_t>(page.triangles.size())}};
  return page;
}

}  // namespace page_splitter

/// Cuts a mesh by kd halves into pages of at most `triangles_max` triangles.
inline SplitMesh split_into_pages(const TriangleMesh& mesh, size_t triangles_max,
                                  int bits = kPageGridBitsMax) {
  const MeshStatistics statistics = compute_statistics(mesh);
  const GridFrame frame = make_grid_frame(statistics.box_min, statistics.box_max, kDepthMin);
  SplitMesh split{{frame.origin, frame.cell_size * frame.cells_per_side(), bits}, mesh};
  for (Vec3d& vertex : split.rounded.vertices)
    vertex = split.grid.to_file(split.grid.quantise(vertex));
  page_splitter::Faces all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  page_splitter::split(split.rounded, all, triangles_max, split.triangles);
  const auto page_count = page_splitter::pages_of_vertices(mesh, split.triangles);
  const auto normals = vertex_normals(split.rounded.vertices, split.rounded.triangles);
  for (const auto& faces : split.triangles)
    split.vertices.push_back(page_splitter::page_vertices(mesh, faces, page_count));
  for (size_t number = 0; number < split.triangles.size(); ++number)
    split.pages.push_back(page_splitter::make_page(split, number, page_count, normals));
  return split;
}

}  // namespace burnish

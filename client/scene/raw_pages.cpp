#include "client/scene/raw_pages.h"

#include <algorithm>
#include <utility>

#include "client/scene/mesh_normals.h"
#include "client/scene/ridges.h"
#include "client/scene/spatial_order.h"
#include "client/scene/thinned_triangles.h"
#include "common/base/check.h"
#include "common/base/limits.h"
#include "common/grid/grid.h"
#include "common/mesh/reading/vertex_welder.h"

namespace burnish {
namespace {

/// Values that pages take of each vertex of the mesh.
struct VertexAttributes {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<float> ridges;
  const std::vector<Rgba8>& colours;
};

/// The texels that a triangle shows.
struct ShownTexels {
  double texels = 0;
  double area = 0;  ///< file units²
};

/// The texels that the triangles of a page show.
struct TexelSums {
  double sum = 0;
  double area = 0;     ///< file units²
  double densest = 0;  ///< of a triangle, texels per file unit²

  TexelSums with(const ShownTexels& shown) const {
    const double density = shown.area > 0 ? shown.texels / shown.area : 0;
    return {sum + shown.texels, area + shown.area, std::max(densest, density)};
  }
  double if_dense() const { return area * densest; }
};

/// Fills one page after the other.
class PageCutter {
 public:
  explicit PageCutter(const VertexAttributes& attributes)
      : attributes_(attributes),
        page_of_(attributes.positions.size(), kNoPage),
        place_of_(page_of_.size()) {}

  void add(const Triangle& triangle) {
    if (!has_room(triangle)) begin_page();
    put(triangle);
  }

  /// Begins a page also where the last one has `texels_max` texels, or takes twice as many to be
  /// as dense everywhere as where it is densest.
  void add(const Triangle& triangle, const ShownTexels& shown, double texels_max) {
    constexpr double kRoom = 2;
    const TexelSums with = texels_.with(shown);
    if (!has_room(triangle) || with.sum > texels_max || with.if_dense() > kRoom * texels_max)
      begin_page();
    put(triangle);
    texels_ = texels_.with(shown);
  }

  std::vector<PageMesh> take() { return std::move(pages_); }

 private:
  void put(const Triangle& triangle) {
    PageTriangle local;
    for (int corner = 0; corner < 3; ++corner) local[corner] = place_of(triangle[corner]);
    pages_.back().triangles.push_back(local);
  }

  uint32_t newest() const { return static_cast<uint32_t>(pages_.size() - 1); }

  bool has_room(const Triangle& triangle) const {
    if (pages_.empty()) return false;
    size_t vertices = pages_.back().positions.size();
    for (const uint32_t vertex : triangle) vertices += page_of_[vertex] != newest();
    return vertices <= kPageVerticesMax && pages_.back().triangles.size() < kPageTrianglesMax;
  }

  void begin_page() {
    texels_ = {};
    PageMesh& page = pages_.emplace_back();
    page.positions.reserve(kPageVerticesMax);
    page.normals.reserve(kPageVerticesMax);
    page.ridges.reserve(kPageVerticesMax);
    if (!attributes_.colours.empty()) page.colours.reserve(kPageVerticesMax);
    page.triangles.reserve(kPageTrianglesMax);
  }

  uint16_t place_of(uint32_t vertex) {
    if (std::exchange(page_of_[vertex], newest()) == newest()) return place_of_[vertex];
    PageMesh& page = pages_.back();
    place_of_[vertex] = static_cast<uint16_t>(page.positions.size());
    page.positions.push_back(attributes_.positions[vertex]);
    page.normals.push_back(attributes_.normals[vertex]);
    page.ridges.push_back(attributes_.ridges[vertex]);
    if (!attributes_.colours.empty()) page.colours.push_back(attributes_.colours[vertex]);
    return place_of_[vertex];
  }

  const VertexAttributes& attributes_;
  std::vector<PageMesh> pages_;
  std::vector<uint32_t> page_of_;   // per vertex, the last page that has it
  std::vector<uint16_t> place_of_;  // per vertex, its number in that page
  TexelSums texels_;                // of the newest page
};

}  // namespace

Eigen::AlignedBox3d referenced_box(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : mesh.triangles)
    for (const uint32_t vertex : triangle) box.extend(mesh.vertices[vertex]);
  return box;
}

// The window's cube, so that ridges are shaded alike: they depend on the unit.
PageSpace raw_page_space(const Eigen::AlignedBox3d& box) {
  if (box.sizes().maxCoeff() <= 0) return {box.center()};
  const GridFrame frame = make_grid_frame(box.min(), box.max(), kDepthMin);
  const double half = frame.cell_size * frame.cells_per_side() / 2;
  return {frame.origin + Vec3d::Constant(half), half, 0};
}

namespace {

/// A mesh that has each position once. Seams of texture coordinates have vertices twice, and must
/// not show as lines.
struct JoinedSurface {
  std::vector<Vec3d> vertices;
  std::vector<uint32_t> of_vertex;
  std::vector<Triangle> triangles;

  explicit JoinedSurface(const TriangleMesh& mesh) : triangles(mesh.triangles) {
    VertexWelder welder(vertices);
    of_vertex.reserve(mesh.vertices.size());
    for (const Vec3d& vertex : mesh.vertices) of_vertex.push_back(welder.index_of(vertex));
    for (Triangle& triangle : triangles)
      for (uint32_t& vertex : triangle) vertex = of_vertex[vertex];
  }
};

}  // namespace

static VertexAttributes attributes_of(const TriangleMesh& mesh, const PageSpace& space) {
  const JoinedSurface joined(mesh);
  std::vector<Vec3f> positions;
  positions.reserve(joined.vertices.size());
  for (const Vec3d& vertex : joined.vertices)
    positions.push_back(((vertex - space.centre) / space.unit).cast<float>());
  const std::vector<Vec3f> normals = vertex_normals(joined.vertices, joined.triangles);
  const std::vector<float> ridges = vertex_ridges(positions, normals, joined.triangles);
  VertexAttributes attributes{{}, {}, {}, mesh.colours};
  for (const uint32_t vertex : joined.of_vertex) {
    attributes.positions.push_back(positions[vertex]);
    attributes.normals.push_back(normals[vertex]);
    attributes.ridges.push_back(ridges[vertex]);
  }
  return attributes;
}

namespace {

/// A mesh on its way into pages.
class RawMaker {
 public:
  explicit RawMaker(const TriangleMesh& mesh)
      : box_(referenced_box(mesh)),
        space_(raw_page_space(box_)),
        attributes_(attributes_of(mesh, space_)) {}

  /// Calls add(cutter, triangle) for the number of each triangle of `mesh`, in spatial order.
  template <typename Add>
  RawPages cut(const TriangleMesh& mesh, const Add& add) const {
    RawPages raw{space_, box_, {}};
    PageCutter cutter(attributes_);
    raw.triangles = spatial_order(mesh, box_);
    for (const uint32_t triangle : raw.triangles) add(cutter, triangle);
    raw.pages = cutter.take();
    return raw;
  }

 private:
  const Eigen::AlignedBox3d box_;
  const PageSpace space_;
  const VertexAttributes attributes_;
};

}  // namespace

RawPages make_raw_pages(const TriangleMesh& mesh, uint64_t triangles_max) {
  const RawMaker maker(mesh);
  const auto cut = [&](const TriangleMesh& shown) {
    return maker.cut(shown, [&](PageCutter& cutter, uint32_t triangle) {
      cutter.add(shown.triangles[triangle]);
    });
  };
  if (mesh.triangles.size() <= triangles_max) return cut(mesh);
  RawPages thinned = cut({mesh.vertices, thinned_triangles(mesh, triangles_max), {}});
  thinned.triangles = {};
  return thinned;
}

RawPages make_raw_pages(const TriangleMesh& mesh, std::span<const float> texels,
                        double texels_max) {
  BURNISH_CHECK(texels.size() == mesh.triangles.size(), "a number of texels per triangle");
  return RawMaker(mesh).cut(mesh, [&](PageCutter& cutter, uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec3d along = mesh.vertices[b] - mesh.vertices[a];
    const Vec3d across = mesh.vertices[c] - mesh.vertices[a];
    const double area = along.cross(across).norm() / 2;
    cutter.add(mesh.triangles[triangle], {texels[triangle], area}, texels_max);
  });
}

}  // namespace burnish

#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "client/scene/page_mesh.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_texture.h"

namespace burnish {

/// A unit normal and a ridge (vertex_ridges()), each times 32767.
struct RasterNormal {
  int16_t x = 0, y = 0, z = 0, ridge = 0;
};

RasterNormal raster_normal(const Vec3f& normal, float ridge);

/// So many triangles that follow each other have a box, so that a page may be hidden in part.
inline constexpr uint32_t kRunTriangles = 128;

/// Holds one surface of a page: with its displacements, or without.
struct RasterSurface {
  std::vector<Vec3f> positions;
  std::vector<RasterNormal> normals;
  Eigen::AlignedBox3f box;
  std::vector<Eigen::AlignedBox3f> run_boxes;  // one per kRunTriangles triangles
  Vec3f mean_normal = Vec3f::Zero();           // of the vertices; any length
};

/// The page in a slot. Fields are empty that nobody has given: 20 bytes a vertex that is not moved,
/// 24 more if it is, and 6 a triangle.
struct RasterPage {
  std::vector<PageTriangle> triangles;
  RasterSurface original;
  RasterSurface moved;              // empty: nothing moved
  std::vector<float> along_normal;  // of the displacement, cells
  std::vector<VertexMark> marks;
  std::vector<Rgba8> original_colours;
  std::vector<Rgba8> moved_colours;
  std::vector<TexelChange> moved_texels;
  std::shared_ptr<const PageTexture> texture;  // null: there is none

  size_t vertices() const { return original.positions.size(); }
  const RasterSurface& surface(bool of_original) const {
    return of_original || moved.positions.empty() ? original : moved;
  }
  std::span<const Rgba8> colours(bool of_original) const {
    return of_original || moved_colours.empty() ? original_colours : moved_colours;
  }

  void put(const PageMesh& mesh);
  /// Moves as the shader of client/gl does, so that vertices that pages share end at one place.
  void move(std::span<const Vec3f> displacements, std::span<const Vec3f> normals,
            std::span<const float> ridges, float cell_size);
};

}  // namespace burnish

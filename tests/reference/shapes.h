#pragma once

#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "common/mesh/triangle_mesh.h"

/// Shapes with closed forms for the tests, made here and not by the product's generator.
namespace burnish::reference {

/// Splits every triangle in four; new vertices come in the middle of edges.
inline TriangleMesh split_in_four(const TriangleMesh& mesh) {
  TriangleMesh finer{mesh.vertices, {}};
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(finer.vertices.size()));
    if (is_new) finer.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    return found->second;
  };
  for (const Triangle& t : mesh.triangles) {
    const uint32_t ab = middle(t[0], t[1]);
    const uint32_t bc = middle(t[1], t[2]);
    const uint32_t ca = middle(t[2], t[0]);
    finer.triangles.push_back({t[0], ab, ca});
    finer.triangles.push_back({t[1], bc, ab});
    finer.triangles.push_back({t[2], ca, bc});
    finer.triangles.push_back({ab, bc, ca});
  }
  return finer;
}

/// Makes 20 * 4^level triangles, vertices at distance `radius` from the origin, normals outwards.
inline TriangleMesh icosphere(int level, double radius) {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int i = 0; i <= level; ++i) {
    for (Vec3d& v : mesh.vertices) v = radius * v.normalized();
    if (i < level) mesh = split_in_four(mesh);
  }
  return mesh;
}

/// Returns the image of [0, 1]^2 under `surface`: `columns` x `rows` quads cut alternately in two.
/// With `around` the first parameter closes on itself.
template <typename Surface>
TriangleMesh grid_surface(int columns, int rows, bool around, const Surface& surface) {
  TriangleMesh mesh;
  const int width = around ? columns : columns + 1;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < width; ++i)
      mesh.vertices.push_back(surface(double(i) / columns, double(j) / rows));
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto at = [&](int di, int dj) {
        return static_cast<uint32_t>((j + dj) * width + (i + di) % width);
      };
      if ((i + j) % 2 == 0) {
        mesh.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
        mesh.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
      } else {
        mesh.triangles.push_back({at(0, 0), at(1, 0), at(0, 1)});
        mesh.triangles.push_back({at(1, 0), at(1, 1), at(0, 1)});
      }
    }
  }
  return mesh;
}

/// An open cylinder around z, from -height / 2 to height / 2, normals outwards.
inline TriangleMesh open_cylinder(int around, int along, double radius, double height) {
  return grid_surface(around, along, true, [=](double u, double v) {
    const double angle = 2 * std::numbers::pi * u;
    return Vec3d(radius * std::cos(angle), radius * std::sin(angle), height * (v - 0.5));
  });
}

/// Moves every vertex by `map`: rotations, scales, bumps.
template <typename Map>
TriangleMesh mapped(TriangleMesh mesh, const Map& map) {
  for (Vec3d& v : mesh.vertices) v = map(v);
  return mesh;
}

inline TriangleMesh turned_inside_out(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// A sphere with lumps of several wavelengths along each axis: smooth, closed, without symmetry.
inline TriangleMesh bumpy_sphere(int level) {
  return mapped(icosphere(level, 1), [](const Vec3d& p) {
    const double lump = std::sin(5 * p.x() + 1) * std::cos(4 * p.y()) + std::sin(6 * p.z() + p.x());
    return Vec3d((1 + 0.06 * lump) * p);
  });
}

/// Returns an arbitrary turn that aligns nothing with the grid.
inline Eigen::Matrix3d skew_turn() {
  return Eigen::AngleAxisd(0.9, Vec3d(1, 2, -1.5).normalized()).toRotationMatrix();
}

}  // namespace burnish::reference

#include "common/measure/deviation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/mesh/agreeing_vertices.h"
#include "common/mesh/corner_normals.h"

namespace burnish {

namespace {

/// The surface before, as seen from its vertices.
struct VertexShape {
  std::vector<Vec3d> normals;  // of length 1; of no length where triangles cancel out
  std::vector<double> areas;   // thirds of the triangles' areas
};

double area_of(std::span<const Vec3d> vertices, const Triangle& t) {
  return (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]).norm() / 2;
}

/// Lets vertices at one place have one normal, so that a measure does not depend on how the file
/// shares vertices.
void join_normals(std::span<const Vec3d> vertices, std::span<const Triangle> triangles,
                  std::vector<Vec3d>& normals) {
  MeshView mesh;
  mesh.vertices = vertices;
  mesh.triangles = triangles;
  const ScratchArray<uint32_t> least = least_that_agree(mesh);
  for (size_t v = 0; v < least.size(); ++v)
    if (least[v] != v) normals[least[v]] += normals[v];
  for (size_t v = 0; v < least.size(); ++v) normals[v] = normals[least[v]];
}

VertexShape shape_of(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  VertexShape shape{std::vector<Vec3d>(vertices.size(), Vec3d::Zero()),
                    std::vector<double>(vertices.size(), 0)};
  for (const Triangle& t : triangles) {
    const auto normals = corner_normals(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    const double third = area_of(vertices, t) / 3;
    for (int c = 0; c < 3; ++c) {
      shape.normals[t[c]] += normals[c];
      shape.areas[t[c]] += third;
    }
  }
  join_normals(vertices, triangles, shape.normals);
  for (Vec3d& normal : shape.normals) normal = normal.stableNormalized();
  return shape;
}

/// Measures from a point of the surface, because coordinates of surveys are far from zero.
double volume_of(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  const Vec3d origin = vertices[triangles.front()[0]];
  double six = 0;
  for (const Triangle& t : triangles)
    six += (vertices[t[0]] - origin).dot((vertices[t[1]] - origin).cross(vertices[t[2]] - origin));
  return six / 6;
}

double area_of(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += area_of(vertices, t);
  return sum;
}

/// The move of each vertex along its normal.
std::vector<double> heights_of(std::span<const Vec3d> before, std::span<const Vec3d> after,
                               const VertexShape& shape) {
  std::vector<double> heights(before.size());
  for (size_t v = 0; v < before.size(); ++v)
    heights[v] = shape.normals[v].dot(after[v] - before[v]);
  return heights;
}

void add_ways(std::span<const Vec3d> before, std::span<const Vec3d> after,
              std::span<const double> areas, Deviation& deviation) {
  double squares = 0;
  for (size_t v = 0; v < before.size(); ++v) {
    const double way = (after[v] - before[v]).norm();
    if (areas[v] > 0 && way > deviation.max) {
      deviation.max = way;
      deviation.farthest = before[v];
    }
    deviation.mean += areas[v] * way;
    squares += areas[v] * way * way;
  }
  deviation.mean /= deviation.area_before;
  deviation.rms = std::sqrt(squares / deviation.area_before);
}

AxisMoves moves_along(int axis, std::span<const Vec3d> before, std::span<const Vec3d> after,
                      std::span<const double> areas, double area) {
  AxisMoves moves;
  double squares = 0;
  for (size_t v = 0; v < before.size(); ++v) {
    if (areas[v] == 0) continue;
    const double move = after[v][axis] - before[v][axis];
    moves.least = std::min(moves.least, move);
    moves.most = std::max(moves.most, move);
    moves.mean += areas[v] * move / area;
    squares += areas[v] * move * move;
  }
  moves.rms = std::sqrt(squares / area);
  return moves;
}

void add_heights(std::span<const double> heights, std::span<const double> areas,
                 Deviation& deviation) {
  for (size_t v = 0; v < heights.size(); ++v) {
    deviation.mean_along_normal += areas[v] * heights[v] / deviation.area_before;
    if (areas[v] == 0) continue;
    deviation.outward_max = std::max(deviation.outward_max, heights[v]);
    deviation.inward_max = std::max(deviation.inward_max, -heights[v]);
  }
  deviation.histogram_range = std::max(deviation.outward_max, deviation.inward_max);
}

void add_histogram(std::span<const double> heights, std::span<const double> areas,
                   Deviation& deviation) {
  const double range = deviation.histogram_range;
  for (size_t v = 0; v < heights.size(); ++v) {
    const double part = range > 0 ? (heights[v] + range) / (2 * range) : 0.5;
    const int bin = std::clamp(static_cast<int>(part * Deviation::kBins), 0, Deviation::kBins - 1);
    deviation.histogram[bin] += areas[v] / deviation.area_before;
  }
}

}  // namespace

Deviation deviation_of(std::span<const Vec3d> before, std::span<const Vec3d> after,
                       std::span<const Triangle> triangles) {
  Deviation deviation;
  deviation.area_before = area_of(before, triangles);
  deviation.area_after = area_of(after, triangles);
  deviation.volume_before = volume_of(before, triangles);
  deviation.volume_after = volume_of(after, triangles);
  const VertexShape shape = shape_of(before, triangles);
  add_ways(before, after, shape.areas, deviation);
  const std::vector<double> heights = heights_of(before, after, shape);
  add_heights(heights, shape.areas, deviation);
  add_histogram(heights, shape.areas, deviation);
  deviation.axes.emplace();
  for (int axis = 0; axis < 3; ++axis)
    (*deviation.axes)[static_cast<size_t>(axis)] =
        moves_along(axis, before, after, shape.areas, deviation.area_before);
  return deviation;
}

}  // namespace burnish

#include "common/generate/surface_noise.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "common/generate/noise.h"
#include "common/generate/scanner.h"
#include "common/mesh/joined_mesh.h"

namespace burnish {
namespace {

constexpr int kAverages = 6;          // of neighbours: alike over about three edges
constexpr double kStepPerNoise = 2;   // of depths
constexpr double kStepDither = 0.05;  // of an edge, so that no line of steps is straight
const Vec3d kView(0.4, 0.7, 0.6);

/// A sum of twelve uniforms: within six deviations, and with tails like a Gaussian's to about
/// three.
double normal_number(uint64_t seed, uint64_t index) {
  double sum = 0;
  for (uint64_t use = 0; use < 3; ++use) sum += bounded_normal(sub_seed(seed, use), index);
  return sum / std::numbers::sqrt3;
}

/// The mesh with its vertices at one place as one.
TriangleMesh welded(const TriangleMesh& mesh, const ScratchArray<uint32_t>& place) {
  TriangleMesh result = mesh;
  for (Triangle& triangle : result.triangles)
    for (uint32_t& v : triangle) v = place[v];
  return result;
}

/// Replaces each value by the mean of it and its neighbours' mean.
void average(const std::vector<Triangle>& triangles, std::vector<double>& values) {
  std::vector<double> sum(values.size(), 0), count(values.size(), 0);
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) {
      sum[t[i]] += values[t[(i + 1) % 3]] + values[t[(i + 2) % 3]];
      count[t[i]] += 2;
    }
  for (size_t v = 0; v < values.size(); ++v)
    if (count[v] > 0) values[v] = 0.5 * values[v] + 0.5 * sum[v] / count[v];
}

double deviation_of(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count)));
}

/// Returns noise of deviation 1 that neighbours share.
std::vector<double> correlated_noise(const TriangleMesh& mesh, uint64_t seed) {
  std::vector<double> values(mesh.vertices.size());
  for (size_t v = 0; v < values.size(); ++v) values[v] = normal_number(seed, v);
  for (int i = 0; i < kAverages; ++i) average(mesh.triangles, values);
  const double deviation = deviation_of(values);
  for (double& value : values) value /= deviation > 0 ? deviation : 1;
  return values;
}

void move_places(TriangleMesh& mesh, const ScratchArray<uint32_t>& place,
                 const std::vector<Vec3d>& moves) {
  for (size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertices[v] += moves[place[v]];
}

}  // namespace

double mean_edge(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) sum += (mesh.vertices[t[(i + 1) % 3]] - mesh.vertices[t[i]]).norm();
  return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

void add_white_noise(TriangleMesh& mesh, double deviation, uint64_t seed) {
  const ScratchArray<uint32_t> place = least_at_places(mesh.vertices);
  std::vector<Vec3d> moves = vertex_normals(welded(mesh, place));
  const double size = deviation * mean_edge(mesh);
  for (size_t v = 0; v < moves.size(); ++v) moves[v] *= size * normal_number(seed, v);
  move_places(mesh, place, moves);
}

void add_structured_light_noise(TriangleMesh& mesh, double deviation, uint64_t seed) {
  const ScratchArray<uint32_t> place = least_at_places(mesh.vertices);
  const TriangleMesh joined = welded(mesh, place);
  const std::vector<double> along_normal = correlated_noise(joined, sub_seed(seed, 0));
  const double edge = mean_edge(mesh), step = kStepPerNoise * deviation;
  const Vec3d view = kView / kView.norm();
  std::vector<Vec3d> moves = vertex_normals(joined);
  for (size_t v = 0; v < moves.size(); ++v) {
    const double depth =
        mesh.vertices[v].dot(view) / edge + kStepDither * normal_number(sub_seed(seed, 1), v);
    const double to_step = step > 0 ? std::round(depth / step) * step - depth : 0;
    moves[v] = edge * (deviation * along_normal[v] * moves[v] + to_step * view);
  }
  move_places(mesh, place, moves);
}

}  // namespace burnish

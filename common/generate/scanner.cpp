#include "common/generate/scanner.h"

#include "common/generate/noise.h"

namespace burnish {

std::vector<Vec3d> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3d> normals(mesh.vertices.size(), Vec3d::Zero());
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3d& a = mesh.vertices[triangle[0]];
    const Vec3d twice_area = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
    for (uint32_t v : triangle) normals[v] += twice_area;
  }
  for (Vec3d& normal : normals) normal.normalize();  // leaves zero as it is
  return normals;
}

void add_scanner_noise(TriangleMesh& mesh, const ScannerNoise& noise, uint64_t seed) {
  constexpr double kGradientNoiseDeviation = 0.25;
  const std::vector<Vec3d> normals = vertex_normals(mesh);
  const uint64_t white_seed = sub_seed(seed, 0), correlated_seed = sub_seed(seed, 1);
  const double correlated = noise.correlated / kGradientNoiseDeviation;
#pragma omp parallel for
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    Vec3d& p = mesh.vertices[v];
    const Vec3d at = p / noise.correlation_length;
    p += normals[v] * (noise.white * bounded_normal(white_seed, v) +
                       correlated * gradient_noise(at, correlated_seed));
  }
}

void round_to_float(TriangleMesh& mesh) {
  // Goes through memory: the vectoriser of g++ 12.2 drops a double's round trip through float
  // registers.
  std::vector<Vec3f> rounded(mesh.vertices.size());
  for (size_t v = 0; v < rounded.size(); ++v) rounded[v] = mesh.vertices[v].cast<float>();
  for (size_t v = 0; v < rounded.size(); ++v) mesh.vertices[v] = rounded[v].cast<double>();
  mesh.has_double_positions = false;
}

}  // namespace burnish

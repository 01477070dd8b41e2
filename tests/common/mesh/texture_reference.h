#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/mesh/srgb.h"
#include "common/mesh/textures/texture_wrap.h"
#include "common/mesh/triangle_mesh.h"
#include "common/picture/picture.h"

namespace burnish {

/// Texture coordinates of a triangle's corners, from the picture's top left corner.
using ReferenceCorners = std::array<Eigen::Vector2d, 3>;

/// Returns the number of the pixel that an endless texture has at `i`.
inline uint32_t reference_pixel(int64_t i, int64_t size, TextureWrap wrap) {
  if (wrap == TextureWrap::kClamp)
    return static_cast<uint32_t>(std::clamp(i, int64_t{0}, size - 1));
  const int64_t period = wrap == TextureWrap::kMirror ? 2 * size : size;
  const int64_t rest = (i % period + period) % period;
  return static_cast<uint32_t>(rest < size ? rest : period - 1 - rest);
}

/// Returns linear light at a texture coordinate, between four pixels.
inline Vec3d reference_sample(const Picture& picture, const Eigen::Vector2d& place,
                              const TextureWraps& wraps) {
  const double x = place.x() * picture.width - 0.5, y = place.y() * picture.height - 0.5;
  const auto column = static_cast<int64_t>(std::floor(x)),
             row = static_cast<int64_t>(std::floor(y));
  Vec3d sum = Vec3d::Zero();
  for (int64_t i = column; i <= column + 1; ++i)
    for (int64_t j = row; j <= row + 1; ++j) {
      const Rgba8& pixel = picture.at(reference_pixel(i, picture.width, wraps.u),
                                      reference_pixel(j, picture.height, wraps.v));
      const double weight =
          (1 - std::abs(x - static_cast<double>(i))) * (1 - std::abs(y - static_cast<double>(j)));
      sum += weight * linear_colour(pixel).cast<double>();
    }
  return sum;
}

/// Returns the mean colour of what each vertex owns of a textured mesh: the points of its triangles
/// that are nearest to it, sampled one by one.
inline std::vector<Rgba8> reference_colours(const TriangleMesh& mesh,
                                            const std::vector<ReferenceCorners>& corners,
                                            const Picture& picture, const TextureWraps& wraps) {
  constexpr int kSteps = 400;  // along a side
  std::vector<Vec3d> sums(mesh.vertices.size(), Vec3d::Zero());
  std::vector<double> weights(mesh.vertices.size(), 0);
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3d& origin = mesh.vertices[a];
    const double area = (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin).norm() / 2;
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; j + i < kSteps; ++j) {
        Vec3d at((i + 1 / 3.0) / kSteps, (j + 1 / 3.0) / kSteps, 0);
        at[2] = 1 - at[0] - at[1];
        Eigen::Index nearest;
        at.maxCoeff(&nearest);
        const Eigen::Vector2d place =
            at[0] * corners[t][0] + at[1] * corners[t][1] + at[2] * corners[t][2];
        const uint32_t vertex = mesh.triangles[t][static_cast<size_t>(nearest)];
        sums[vertex] += area * reference_sample(picture, place, wraps);
        weights[vertex] += area;
      }
  }
  std::vector<Rgba8> colours;
  for (size_t v = 0; v < sums.size(); ++v) {
    const Vec3f mean = (sums[v] / weights[v]).cast<float>();
    colours.push_back({srgb_byte(mean[0]), srgb_byte(mean[1]), srgb_byte(mean[2]), 255});
  }
  return colours;
}

/// Returns the largest difference of two lists of colours in levels of a channel.
inline int largest_difference(const std::vector<Rgba8>& a, const std::vector<Rgba8>& b) {
  if (a.size() != b.size()) return 256;
  int largest = 0;
  for (size_t v = 0; v < a.size(); ++v)
    for (size_t i = 0; i < 4; ++i) largest = std::max(largest, std::abs(a[v][i] - b[v][i]));
  return largest;
}

}  // namespace burnish

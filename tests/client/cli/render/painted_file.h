#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include <Eigen/Dense>

#include "client/pictures/picture.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/sheets/painted_ball.h"

namespace burnish {

/// A painted ball in a file of its own.
struct PaintedFile {
  explicit PaintedFile(const PaintedBall& painted) : ball(painted), zip(ball.zip()) {
    path = folder.write("ball.zip", {zip.begin(), zip.end()});
    mesh = read_mesh(path).value();
  }

  PaintedBall ball;
  std::vector<uint8_t> zip;
  TemporaryFolder folder;
  std::filesystem::path path;
  TriangleMesh mesh;
};

/// Returns where a ray first meets a mesh.
inline std::optional<Vec3d> first_hit(const TriangleMesh& mesh, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3d& a = mesh.vertices[triangle[0]];
    Eigen::Matrix3d sides;
    sides << mesh.vertices[triangle[1]] - a, mesh.vertices[triangle[2]] - a, -ray.direction;
    const Vec3d found = sides.inverse() * (ray.origin - a);
    const bool is_inside = found.x() >= 0 && found.y() >= 0 && found.x() + found.y() <= 1;
    if (is_inside && found.z() > 0) nearest = std::min(nearest, found.z());
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  return ray.origin + nearest * ray.direction;
}

/// Returns the part of the ball's pixels whose colour is the pattern's, to 20 levels.
inline double part_alike(const PaintedFile& file, const Image& image,
                         const PictureOptions& options) {
  const Camera camera = picture_camera(options, referenced_box(file.mesh));
  int alike = 0, all = 0;
  for (int y = 3; y < image.size.height; y += 7)
    for (int x = 3; x < image.size.width; x += 7) {
      const auto hit = first_hit(file.mesh, pixel_ray(camera, image.size, {x + 0.5, y + 0.5}));
      if (!hit) continue;
      const Rgba8 pattern = file.ball.colour_at(*hit);
      bool is_alike = true;
      for (int c = 0; c < 3; ++c) is_alike &= std::abs(pattern[c] - image.pixel(x, y)[c]) < 20;
      alike += is_alike;
      ++all;
    }
  return all < 100 ? 0 : double(alike) / all;
}

inline PictureOptions unlit_picture(const ImageSize& size) {
  PictureOptions options{.size = size};
  options.style.lighting.kind = LightKind::kUnlit;
  return options;
}

}  // namespace burnish

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tests/common/gltf/glb_file.h"
#include "tests/common/picture/encoding.h"

namespace burnish {

/// A square of cells x cells quads, whose texture coordinates fill a part of the picture. They are
/// skewed, so that sides do not run along rows of texels.
struct TexturedGrid {
  int cells = 6;
  double begin = 0.13, end = 0.88;  // of the coordinates, both axes
  double shift = 0;                 // of all coordinates, along both axes

  int side() const { return cells + 1; }
  std::array<double, 2> coordinate(int x, int y) const {
    const double u = static_cast<double>(x) / cells, v = static_cast<double>(y) / cells;
    return {shift + begin + (end - begin) * (0.9 * u + 0.1 * v),
            shift + begin + (end - begin) * (0.85 * v + 0.15 * u)};
  }

  /// Calls `use(x, y)` for each vertex, and `face(a, b, c)` for each triangle, from 0.
  template <typename Use>
  void each_vertex(const Use& use) const {
    for (int y = 0; y < side(); ++y)
      for (int x = 0; x < side(); ++x) use(x, y);
  }
  template <typename Face>
  void each_face(const Face& face) const {
    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x) {
        const int a = y * side() + x;
        face(a, a + 1, a + side() + 1);
        face(a, a + side() + 1, a + side());
      }
  }

  std::string obj() const {
    std::string text = "mtllib skin.mtl\n", faces = "usemtl skin\n";
    each_vertex([&](int x, int y) {
      const auto [u, v] = coordinate(x, y);
      text += "v " + std::to_string(x) + " " + std::to_string(y) + " " +
              std::to_string((x * y) % 3 * 0.1) + "\nvt " + std::to_string(u) + " " +
              std::to_string(v) + "\n";
    });
    const auto corner = [](int i) { return std::to_string(i + 1) + "/" + std::to_string(i + 1); };
    each_face([&](int a, int b, int c) {
      faces += "f " + corner(a) + " " + corner(b) + " " + corner(c) + "\n";
    });
    return text + faces;
  }

  std::string ply() const {
    std::string text =
        "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex " +
        std::to_string(side() * side()) +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty float s\nproperty "
        "float t\nelement face " +
        std::to_string(2 * cells * cells) +
        "\nproperty list uchar int vertex_indices\nend_header\n";
    each_vertex([&](int x, int y) {
      const auto [u, v] = coordinate(x, y);
      text += std::to_string(x) + " " + std::to_string(y) + " " +
              std::to_string((x * y) % 3 * 0.1) + " " + std::to_string(u) + " " +
              std::to_string(v) + "\n";
    });
    each_face([&](int a, int b, int c) {
      text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    });
    return text;
  }

  /// The picture lies between the positions and the indices, so views behind it may have to move.
  GlbFile glb(const std::string& picture) const {
    GlbFile file;
    std::vector<float> positions, coordinates;
    each_vertex([&](int x, int y) {
      for (const double p : {1.0 * x, 1.0 * y, (x * y) % 3 * 0.1})
        positions.push_back(static_cast<float>(p));
      const auto [u, v] = coordinate(x, y);
      for (const double c : {u, 1 - v}) coordinates.push_back(static_cast<float>(c));
    });
    std::vector<uint16_t> corners;
    each_face([&](int a, int b, int c) {
      for (const int i : {a, b, c}) corners.push_back(static_cast<uint16_t>(i));
    });
    const auto count = static_cast<size_t>(side() * side());
    const TestJson attributes = {{"POSITION", file.add_floats("VEC3", count, positions)},
                                 {"TEXCOORD_0", file.add_floats("VEC2", count, coordinates)}};
    file.json["images"] = {{{"bufferView", file.add_view(picture)}, {"mimeType", "image/png"}}};
    TestJson& primitive = file.add_primitive(attributes);
    primitive["indices"] = file.add_indices(corners);
    primitive["material"] = 0;
    file.json["textures"] = {{{"source", 0}}};
    file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    return file;
  }
};

inline const std::string kSkinMtl = "newmtl skin\nmap_Kd skin.png\n";

/// Soft colours, of which none is black or white.
inline Picture grid_skin(uint32_t width = 120, uint32_t height = 90) {
  return drawn(width, height, [](uint32_t x, uint32_t y) {
    const auto wave = [&](double a, double b) {
      return static_cast<uint8_t>(125 + 70 * std::sin(a * x + b * y));
    };
    return Rgba8{wave(0.13, 0.05), wave(0.02, 0.21), wave(0.4, -0.3), 255};
  });
}

/// Changes the colours of a grid's vertices, but for those on the left.
inline void paint_right_side(TriangleMesh& mesh) {
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double x = mesh.vertices[v].x();
    if (x < 2) continue;
    for (size_t i = 0; i < 3; ++i)
      mesh.colours[v][i] = static_cast<uint8_t>(
          std::clamp(mesh.colours[v][i] + 12 * x * (i == 1 ? -1 : 0.7), 0.0, 255.0));
  }
}

/// The share of each corner at a point on a picture; nothing outside the triangle.
inline std::optional<Vec3d> weights_at(const std::array<Eigen::Vector2d, 3>& corners,
                                       const Eigen::Vector2d& at) {
  Eigen::Matrix2d sides;
  sides << corners[1] - corners[0], corners[2] - corners[0];
  const Eigen::Vector2d part = sides.inverse() * (at - corners[0]);
  const Vec3d weights(1 - part.sum(), part.x(), part.y());
  if (!(weights.minCoeff() >= 0)) return std::nullopt;
  return weights;
}

inline double light_of_level(double level) {
  return std::pow(level / 255, 2.2);
}

/// Returns what renderers show of a texel that changes so (surface_colour of
/// client/gl/texel_shader.cpp), as a byte.
inline double shown_channel(double texel, double change, double gain = 1) {
  const double sum = gain * light_of_level(texel) + change;
  return 255 * std::pow(std::clamp(sum, 0.0, 1.0), 1 / 2.2);
}

}  // namespace burnish

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/generate/generate.h"
#include "common/generate/lattice.h"

namespace burnish {

/// Takes the corners of three golden rectangles; the 20 faces are the triples of mutual neighbours.
static TriangleMesh make_icosahedron(double radius) {
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (double one : {-1.0, 1.0})
      for (double golden : {-std::numbers::phi, std::numbers::phi}) {
        Vec3d p = Vec3d::Zero();
        p[axis] = one;
        p[(axis + 1) % 3] = golden;
        mesh.vertices.push_back(p.normalized() * radius);
      }
  const auto neighbours = [&](uint32_t a, uint32_t b) {
    return mesh.vertices[a].dot(mesh.vertices[b]) > 0;
  };
  for (uint32_t a = 0; a < 12; ++a)
    for (uint32_t b = a + 1; b < 12; ++b)
      for (uint32_t c = b + 1; c < 12; ++c) {
        if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
        const bool outward = mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) > 0;
        mesh.triangles.push_back(outward ? Triangle{a, b, c} : Triangle{a, c, b});
      }
  return mesh;
}

/// The midpoints made so far, found by the lower end of their edge. On an icosphere a vertex has at
/// most six edges.
struct Midpoints {
  struct Edge {
    uint32_t upper_end = 0;
    uint32_t midpoint = 0;  // 0: a free slot; midpoints come after the old vertices
  };
  std::vector<std::array<Edge, 6>> edges_of_lower_end;
};

static uint32_t midpoint(TriangleMesh& mesh, Midpoints& midpoints, uint32_t a, uint32_t b,
                         double radius) {
  const auto [lower, upper] = std::minmax(a, b);
  size_t slot = 0;
  auto& edges = midpoints.edges_of_lower_end[lower];
  while (edges[slot].midpoint != 0 && edges[slot].upper_end != upper) ++slot;
  if (edges[slot].midpoint == 0) {
    edges[slot] = {upper, static_cast<uint32_t>(mesh.vertices.size())};
    mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized() * radius);
  }
  return edges[slot].midpoint;
}

static void split_every_triangle(TriangleMesh& mesh, double radius) {
  Midpoints midpoints;
  midpoints.edges_of_lower_end.resize(mesh.vertices.size());
  mesh.vertices.reserve(4 * mesh.vertices.size());
  std::vector<Triangle> split;
  split.reserve(4 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const uint32_t ab = midpoint(mesh, midpoints, a, b, radius);
    const uint32_t bc = midpoint(mesh, midpoints, b, c, radius);
    const uint32_t ca = midpoint(mesh, midpoints, c, a, radius);
    split.insert(split.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(split);
}

TriangleMesh make_icosphere(int level, double radius) {
  TriangleMesh mesh = make_icosahedron(radius);
  for (int i = 0; i < level; ++i) split_every_triangle(mesh, radius);
  mesh.has_double_positions = true;
  return mesh;
}

TriangleMesh make_cylinder(int around, int along, double radius, double height) {
  TriangleMesh mesh;
  for (int row = 0; row <= along; ++row)
    for (int column = 0; column < around; ++column) {
      const double angle = 2 * std::numbers::pi * column / around;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                 height * (static_cast<double>(row) / along - 0.5));
    }
  for (int row = 0; row < along; ++row)
    for (int column = 0; column < around; ++column) {
      const uint32_t below = static_cast<uint32_t>(row) * around;
      const uint32_t next = column + 1 == around ? 0 : column + 1;
      add_quad(mesh, below + column, below + next, below + around + next, below + around + column);
    }
  mesh.has_double_positions = true;
  return mesh;
}

TriangleMesh make_sheet(int side, double width, double bump_height) {
  TriangleMesh mesh;
  const double deviation = width / 10;
  for (int row = 0; row <= side; ++row)
    for (int column = 0; column <= side; ++column) {
      const double x = width * column / side, y = width * row / side;
      const double dx = (x - width / 2) / deviation, dy = (y - width / 2) / deviation;
      mesh.vertices.emplace_back(x, y, bump_height * std::exp(-(dx * dx + dy * dy) / 2));
    }
  add_lattice_quads(mesh, 0, side + 1, side + 1);
  mesh.has_double_positions = true;
  return mesh;
}

}  // namespace burnish

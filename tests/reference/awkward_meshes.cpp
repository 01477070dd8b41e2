#include "tests/reference/awkward_meshes.h"

#include <array>
#include <random>

#include "tests/reference/shapes.h"

namespace burnish::reference {

namespace {

constexpr int kSide = 12;  // steps of a sixteenth of the cube; the box itself is 14.4

/// Returns whether the unit block at (i, j, k) belongs to the pyramid.
bool is_solid(int i, int j, int k) {
  if (k < 0 || k >= kSide / 2) return false;
  const int margin = k;
  return i >= margin && j >= margin && i < kSide - margin && j < kSide - margin;
}

/// Adds the face of block `at` towards +axis or -axis as two triangles, seen from outside.
void add_face(TriangleMesh& mesh, std::map<std::array<int, 3>, uint32_t>& vertex_at,
              std::array<int, 3> at, int axis, int towards) {
  std::array<uint32_t, 4> quad;
  for (int corner = 0; corner < 4; ++corner) {
    std::array<int, 3> p = at;
    p[axis] += towards > 0;
    p[(axis + 1) % 3] += corner == 1 || corner == 2;
    p[(axis + 2) % 3] += corner >= 2;
    const auto [found, is_new] =
        vertex_at.try_emplace(p, static_cast<uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.emplace_back(p[0], p[1], p[2]);
    quad[corner] = found->second;
  }
  if (towards < 0) std::swap(quad[1], quad[3]);
  mesh.triangles.push_back({quad[0], quad[1], quad[2]});
  mesh.triangles.push_back({quad[0], quad[2], quad[3]});
}

}  // namespace

TriangleMesh stepped_block(int splits) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, uint32_t> vertex_at;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j)
      for (int k = 0; k < kSide / 2; ++k)
        for (int axis = 0; axis < 3; ++axis)
          for (int towards : {-1, 1}) {
            std::array<int, 3> next{i, j, k};
            next[axis] += towards;
            if (is_solid(i, j, k) && !is_solid(next[0], next[1], next[2]))
              add_face(mesh, vertex_at, {i, j, k}, axis, towards);
          }
  for (int s = 0; s < splits; ++s) mesh = split_in_four(mesh);
  // The lowest step's walls move out until the box is 0.9 * 16 wide. Every other wall and step is
  // then a whole number of sixteenths of the cube from the box's centre.
  return mapped(mesh, [](Vec3d p) {
    for (int axis : {0, 1}) {
      if (p[axis] == 0) p[axis] = -1.2;
      if (p[axis] == kSide) p[axis] = kSide + 1.2;
    }
    return p;
  });
}

TriangleMesh joined(TriangleMesh mesh, const TriangleMesh& other) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return mesh;
}

TriangleMesh bumped_sheet(int side) {
  return grid_surface(side, side, false, [](double u, double v) {
    const double r2 = ((u - 0.4) * (u - 0.4) + (v - 0.55) * (v - 0.55)) / 0.09;
    return Vec3d(u, v, r2 < 1 ? 0.15 * std::pow(1 - r2, 3) : 0);
  });
}

TriangleMesh non_manifold_fan(int side) {
  constexpr int kSheets = 7;
  TriangleMesh fan;
  for (int sheet = 0; sheet < kSheets; ++sheet) {
    const double angle = 2 * std::numbers::pi * (sheet + 0.3) / kSheets;
    const Vec3d out(std::cos(angle), std::sin(angle), 0);
    const TriangleMesh wave = grid_surface(side, side, false, [&](double u, double v) {
      const Vec3d across(-out.y(), out.x(), 0);
      return Vec3d(u * out + 0.05 * u * std::sin(9 * v + sheet) * across + v * Vec3d::UnitZ());
    });
    const auto first = static_cast<uint32_t>(fan.vertices.size());
    fan.vertices.insert(fan.vertices.end(), wave.vertices.begin(), wave.vertices.end());
    // A vertex in the first column lies on the axis and belongs to the first sheet.
    const auto shared = [&](uint32_t v) { return v % (side + 1) == 0 ? v : first + v; };
    for (const Triangle& t : wave.triangles)
      fan.triangles.push_back({shared(t[0]), shared(t[1]), shared(t[2])});
  }
  return fan;
}

TriangleMesh shaken_soup(const TriangleMesh& mesh, double shake) {
  std::mt19937 random(7);
  const auto offset = [&] { return shake * (random() / 4294967295.0 - 0.5); };
  TriangleMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<uint32_t>(soup.vertices.size());
    for (uint32_t v : t)
      soup.vertices.push_back(mesh.vertices[v] + Vec3d(offset(), offset(), offset()));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriangleMesh noisy_sphere(int level, double noise) {
  std::mt19937 random(11);
  return mapped(icosphere(level, 1), [&](const Vec3d& p) {
    return Vec3d((1 + noise * (random() / 4294967295.0 - 0.5)) * p);
  });
}

TriangleMesh two_near_sheets(int side, double gap) {
  const auto sheet = [&](double height) {
    return grid_surface(side, side, false, [=](double u, double v) {
      return Vec3d(u, v, 0.1 * std::sin(3 * u) * std::cos(2 * v) + height);
    });
  };
  return joined(sheet(gap), turned_inside_out(sheet(0)));
}

TriangleMesh sphere_with_debris(int level) {
  TriangleMesh mesh = bumpy_sphere(level);
  const Triangle whole = mesh.triangles[20];
  mesh.vertices.push_back((mesh.vertices[whole[0]] + mesh.vertices[whole[1]]) / 2);
  mesh.triangles.push_back({whole[0], whole[1], static_cast<uint32_t>(mesh.vertices.size() - 1)});
  mesh.triangles.push_back({5, 5, 9});
  mesh.triangles.push_back({4, 4, 4});
  mesh.triangles.push_back(mesh.triangles[10]);
  mesh.vertices.insert(mesh.vertices.begin() + 3, Vec3d(1000, -2000, 3000));
  for (Triangle& t : mesh.triangles)
    for (uint32_t& v : t) v += v >= 3;
  mesh.vertices.push_back(Vec3d(0, 0, 0));
  return mesh;
}

TriangleMesh several_components() {
  const auto sphere_at = [](int level, double radius, const Vec3d& centre) {
    return mapped(icosphere(level, radius), [&](const Vec3d& p) { return Vec3d(p + centre); });
  };
  TriangleMesh mesh = joined(bumpy_sphere(4), sphere_at(3, 0.3, {1.6, 0.2, 0}));
  mesh = joined(mesh, turned_inside_out(sphere_at(2, 0.02, {0, 1.5, 0.3})));
  return joined(mesh, {{{-1.5, 0, 0}, {-1.4, 0.1, 0}, {-1.5, 0.1, 0.1}}, {{0, 1, 2}}});
}

TriangleMesh small_components_over_a_sphere() {
  constexpr int kComponents = 60;
  TriangleMesh mesh = bumpy_sphere(4);
  for (int i = 0; i < kComponents; ++i) {
    const double height = 2 * (i + 0.5) / kComponents - 1, turn = 2.4 * i;
    const double across = std::sqrt(1 - height * height), radius = 1.2 + 0.001 * i;
    const Vec3d at = radius * Vec3d(across * std::cos(turn), across * std::sin(turn), height);
    mesh = joined(std::move(mesh),
                  mapped(icosphere(1, 0.03), [&](const Vec3d& p) { return Vec3d(at + p); }));
  }
  return mesh;
}

TriangleMesh shards_over_a_sphere() {
  constexpr int kShards = 60;
  TriangleMesh mesh = icosphere(4, 1);
  for (int i = 0; i < kShards; ++i) {
    const double height = 2 * (i + 0.5) / kShards - 1, turn = 2.4 * i;
    const double across = std::sqrt(1 - height * height), radius = 1.09 + 0.001 * i;
    const Vec3d at = radius * Vec3d(across * std::cos(turn), across * std::sin(turn), height);
    const auto flat = [&](const Vec3d& p) {
      return Vec3d(at + skew_turn() * p.cwiseProduct(Vec3d(0.02, 0.002, 0.0002)));
    };
    mesh = joined(std::move(mesh), mapped(icosphere(0, 1), flat));
  }
  return mesh;
}

TriangleMesh spiked_sphere() {
  constexpr size_t kVerticesPerSpike = 97;
  TriangleMesh mesh = bumpy_sphere(5);
  for (size_t v = 0; v < mesh.vertices.size(); v += kVerticesPerSpike) mesh.vertices[v] *= 1.4;
  return mesh;
}

TriangleMesh needles() {
  return mapped(open_cylinder(600, 4, 1, 3), [](const Vec3d& p) { return Vec3d(skew_turn() * p); });
}

std::vector<std::pair<std::string, TriangleMesh>> awkward_meshes() {
  const auto far_away = [](const Vec3d& p) { return Vec3d(p + Vec3d(5e5, 4e6, 100)); };
  const auto turn = [](const Vec3d& p) { return Vec3d(skew_turn() * p); };
  return {{"closed smooth", bumpy_sphere(4)},
          {"noisy", noisy_sphere(4, 0.05)},
          {"open sheet with flat parts", bumped_sheet(60)},
          {"open sheet, turned", mapped(bumped_sheet(60), turn)},
          {"open cylinder", open_cylinder(80, 50, 1, 2.5)},
          {"needles", needles()},
          {"non-manifold fan", non_manifold_fan(20)},
          {"soup", shaken_soup(bumpy_sphere(3), 0.02)},
          {"two near sheets", two_near_sheets(40, 0.003)},
          {"inside out", turned_inside_out(bumpy_sphere(4))},
          {"faces in grid planes", stepped_block(1)},
          {"zero-area triangles and unreferenced vertices", sphere_with_debris(4)},
          {"several components", several_components()},
          {"small components", small_components_over_a_sphere()},
          {"spikes", spiked_sphere()},
          {"far from the origin", mapped(bumpy_sphere(4), far_away)}};
}

}  // namespace burnish::reference

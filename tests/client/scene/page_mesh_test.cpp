#include "client/scene/page_mesh.h"

#include <map>

#include <gtest/gtest.h>

#include "client/scene/mesh_normals.h"
#include "client/scene/page_space.h"
#include "client/scene/ridges.h"
#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"
#include "tests/client/scene/random_moves.h"
#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

constexpr int kPageDepth = 6;

double degrees_between(const Vec3f& a, const Vec3f& b) {
  const Vec3d u = a.cast<double>(), v = b.cast<double>();
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

SplitMesh split_blob(size_t triangles_max) {
  return split_into_pages(generate_scan({.kind = "blob", .vertices = 4000}).value(), triangles_max);
}

std::map<std::array<int, 3>, std::vector<std::pair<size_t, size_t>>> shared_points(
    const SplitMesh& split) {
  std::map<std::array<int, 3>, std::vector<std::pair<size_t, size_t>>> shared;
  for (size_t p = 0; p < split.pages.size(); ++p)
    for (size_t v = 0; v < split.pages[p].positions.size(); ++v) {
      const Vec3i& at = split.pages[p].positions[v];
      shared[{at.x(), at.y(), at.z()}].emplace_back(p, v);
    }
  std::erase_if(shared, [](const auto& entry) { return entry.second.size() < 2; });
  return shared;
}

TEST(PageMesh, PositionsAreTheLatticePointsInFileUnitsWithoutRounding) {
  const SplitMesh split = split_into_pages(make_test_sphere(Vec3d(5e6, -4e6, 2e5), 3), 4000);
  const PageSpace space = make_page_space(split.grid, kPageDepth);
  for (const Page& page : split.pages) {
    const PageMesh mesh = make_page_mesh(page, split.grid);
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const Vec3d expected = split.grid.to_file(page.positions[v]);
      ASSERT_LT((space.to_file(mesh.positions[v]) - expected).norm(), 1e-8);  // doubles at 5e6
    }
  }
}

TEST(PageMesh, NeighboursOnTheFinestLatticeAreDifferentFloats) {
  Page page;
  const int last = (1 << kPageGridBitsMax) - 1;
  page.positions = {{0, 0, 0}, {1, 0, 0}, {last, last - 1, 0}, {last, last, 1}};
  page.triangles = {{0, 1, 2}, {1, 2, 3}};
  const PageMesh mesh = make_page_mesh(page, PageGrid{});
  const float step = std::ldexp(1.0f, 1 - kPageGridBitsMax);
  EXPECT_EQ(mesh.positions[1] - mesh.positions[0], Vec3f(step, 0, 0));
  EXPECT_EQ(mesh.positions[3] - mesh.positions[2], Vec3f(0, step, step));
}

TEST(PageMesh, NormalsInsideAPageAreThoseOfTheWholeMesh) {
  const SplitMesh split = split_blob(1000);
  const auto whole = vertex_normals(split.rounded.vertices, split.rounded.triangles);
  for (size_t p = 0; p < split.pages.size(); ++p) {
    const PageMesh mesh = make_page_mesh(split.pages[p], split.grid);
    for (size_t v = 0; v < mesh.normals.size(); ++v)
      ASSERT_LT(degrees_between(mesh.normals[v], whole[split.vertices[p][v]]), 0.01);
  }
}

TEST(PageMesh, NormalsThatThePageCarriesAreTaken) {
  Page page = split_blob(100'000).pages.at(0);
  page.normals.assign(page.positions.size(), Vec3f(0.6f, 0, 0.8f));
  EXPECT_EQ(make_page_mesh(page, PageGrid{}).normals, page.normals);
}

TEST(PageMesh, RidgesInsideAPageAreThoseOfTheWholeMesh) {
  const SplitMesh split = split_blob(2000);
  std::vector<Vec3f> positions(split.rounded.vertices.size());
  std::vector<float> least(positions.size(), 2), most(positions.size(), -2);
  for (size_t p = 0; p < split.pages.size(); ++p) {
    const PageMesh mesh = make_page_mesh(split.pages[p], split.grid);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      const uint32_t v = split.vertices[p][i];
      positions[v] = mesh.positions[i];
      least[v] = std::min(least[v], mesh.ridges[i]);
      most[v] = std::max(most[v], mesh.ridges[i]);
    }
  }
  const auto normals = vertex_normals(split.rounded.vertices, split.rounded.triangles);
  const auto whole = vertex_ridges(positions, normals, split.rounded.triangles);
  size_t same = 0;
  for (size_t v = 0; v < whole.size(); ++v)
    same += std::abs(least[v] - whole[v]) < 1e-3 && std::abs(most[v] - whole[v]) < 1e-3;
  EXPECT_GT(double(same), 0.5 * double(whole.size()));  // others are near borders
}

TEST(MovedPage, SharedPointsHaveTheSameBitsInAllPages) {
  const SplitMesh split = split_blob(500);
  const auto shared = shared_points(split);
  ASSERT_GT(shared.size(), 200u);
  for (uint32_t seed = 1; seed <= 20; ++seed) {
    std::vector<MovedPage> moved;
    for (const Page& page : split.pages)
      moved.push_back(displace(make_page_mesh(page, split.grid), random_moves(page.positions, seed),
                               make_page_space(split.grid, kPageDepth).cell_size));
    for (const auto& [point, places] : shared)
      for (const auto& [page, vertex] : places)
        ASSERT_EQ(moved[page].positions[vertex],
                  moved[places[0].first].positions[places[0].second]);
  }
}

TEST(MovedPage, WithoutDisplacementsNothingChanges) {
  const SplitMesh split = split_blob(1000);
  for (const Page& page : split.pages) {
    const PageMesh mesh = make_page_mesh(page, split.grid);
    const std::vector<Vec3f> none(mesh.positions.size(), Vec3f::Zero());
    const MovedPage moved = displace(mesh, none, 0.1f);
    EXPECT_EQ(moved.positions, mesh.positions);
    for (size_t v = 0; v < mesh.normals.size(); ++v)
      ASSERT_LT(degrees_between(moved.normals[v], mesh.normals[v]), 0.01);
  }
}

TEST(MovedPage, ATurnedPageHasTurnedNormals) {
  const SplitMesh split = split_blob(1000);
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.9f, Vec3f(1, 2, -1).normalized()).toRotationMatrix();
  for (const Page& page : split.pages) {
    const PageMesh mesh = make_page_mesh(page, split.grid);
    std::vector<Vec3f> moves;
    for (const Vec3f& at : mesh.positions) moves.push_back((turn * at - at) * 32);
    const MovedPage moved = displace(mesh, moves, 1.0f / 32);
    for (size_t v = page.border_vertices; v < mesh.normals.size(); ++v)
      ASSERT_LT(degrees_between(moved.normals[v], turn * mesh.normals[v]), 0.02);
  }
}

TEST(MovedPage, NormalsOfBordersTurnWithTheirOwnTriangles) {
  Page page;
  page.positions = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  page.triangles = {{0, 1, 2}};
  page.border_vertices = 3;
  page.normals.assign(3, Vec3f(0, -0.6f, 0.8f));
  const PageMesh mesh = make_page_mesh(page, PageGrid{.bits = 4});
  ASSERT_EQ(mesh.own_sums[0].normalized(), Vec3f::UnitZ());
  const MovedPage moved = displace(mesh, std::vector<Vec3f>{{0, 0, 0}, {0, 0, 0}, {0, -1, 1}}, 1);
  const Vec3f expected =
      Eigen::AngleAxisf(std::numbers::pi_v<float> / 2, Vec3f::UnitX()) * mesh.normals[0];
  for (const Vec3f& normal : moved.normals) EXPECT_LT(degrees_between(normal, expected), 0.05);
}

TEST(MovedPage, NormalsOfASmoothFieldAreThoseOfTheMovedMesh) {
  const SplitMesh split = split_into_pages(make_icosphere(4, 1), 1500);
  TriangleMesh whole = split.rounded;
  const PageSpace space = make_page_space(split.grid, kPageDepth);
  const auto wave = [](const Vec3f& at) {
    return Vec3f(2 * std::sin(4 * at.y()), 0, std::cos(5 * at.x()));
  };
  std::vector<std::vector<Vec3f>> moves;
  for (size_t p = 0; p < split.pages.size(); ++p) {
    const PageMesh mesh = make_page_mesh(split.pages[p], split.grid);
    moves.emplace_back();
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      moves[p].push_back(wave(mesh.positions[v]));
      whole.vertices[split.vertices[p][v]] = space.to_file(mesh.positions[v], moves[p][v]);
    }
  }
  const auto expected = vertex_normals(whole.vertices, whole.triangles);
  for (size_t p = 0; p < split.pages.size(); ++p) {
    const MovedPage moved =
        displace(make_page_mesh(split.pages[p], split.grid), moves[p], space.cell_size);
    for (size_t v = 0; v < moved.normals.size(); ++v) {
      const double bar = v < split.pages[p].border_vertices ? 2 : 0.05;  // degrees
      ASSERT_LT(degrees_between(moved.normals[v], expected[split.vertices[p][v]]), bar);
    }
  }
}

TEST(MovedPage, NormalsStayWhereTheTrianglesHaveNoArea) {
  Page page;
  page.positions = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {4, 4, 4}};
  page.triangles = {{0, 1, 2}, {0, 3, 3}};
  page.border_vertices = 1;
  page.normals = {Vec3f::UnitX()};
  const PageMesh mesh = make_page_mesh(page, PageGrid{.bits = 4});
  EXPECT_EQ(mesh.normals[3], Vec3f::UnitZ());
  const std::vector<Vec3f> onto_one_point = {-mesh.positions[0], -mesh.positions[1],
                                             -mesh.positions[2], -mesh.positions[3]};
  EXPECT_EQ(displace(mesh, onto_one_point, 1).normals, mesh.normals);
}

TEST(MovedPage, APageTurnedInsideOutHasUnitNormals) {
  Page page;
  page.positions = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
  page.triangles = {{0, 1, 2}};
  page.border_vertices = 3;
  page.normals.assign(3, Vec3f(0, 0.6f, 0.8f));
  const PageMesh mesh = make_page_mesh(page, PageGrid{.bits = 4});
  const std::vector<Vec3f> mirror = {{0, 0, 0}, {0, 0, 0}, {0, -2, 0}};
  for (const Vec3f& normal : displace(mesh, mirror, 1).normals) EXPECT_EQ(normal, Vec3f(0, 0, -1));
}

}  // namespace
}  // namespace burnish

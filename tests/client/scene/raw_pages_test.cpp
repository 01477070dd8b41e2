#include "client/scene/raw_pages.h"

#include <map>

#include <gtest/gtest.h>

#include "client/scene/mesh_normals.h"
#include "client/scene/null_page_renderer.h"
#include "client/scene/ridges.h"
#include "common/base/limits.h"
#include "common/generate/generate.h"
#include "common/grid/grid.h"
#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

using Place = std::array<float, 3>;

Place place_at(const Vec3f& at) {
  return {at.x(), at.y(), at.z()};
}

TriangleMesh coloured_blob() {
  TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 20'000}).value();
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v)
    mesh.colours.push_back({uint8_t(v), uint8_t(v >> 8), uint8_t(v >> 16), 255});
  return mesh;
}

TEST(RawPages, HoldAllTrianglesOnceWithinTheLimitsOfPages) {
  const TriangleMesh mesh = coloured_blob();
  const RawPages raw = make_raw_pages(mesh);
  std::map<std::array<Place, 3>, int> balance;
  for (const PageMesh& page : raw.pages) {
    EXPECT_LE(page.positions.size(), kPageVerticesMax);
    EXPECT_LE(page.triangles.size(), kPageTrianglesMax);
    for (const auto& [a, b, c] : page.triangles)
      ++balance[{place_at(page.positions[a]), place_at(page.positions[b]),
                 place_at(page.positions[c])}];
  }
  const auto place_of = [&](uint32_t v) {
    return place_at(((mesh.vertices[v] - raw.space.centre) / raw.space.unit).cast<float>());
  };
  for (const auto& [a, b, c] : mesh.triangles) --balance[{place_of(a), place_of(b), place_of(c)}];
  for (const auto& [triangle, left] : balance) ASSERT_EQ(left, 0);
}

TEST(RawPages, EndWhereTheirTrianglesHaveEnoughTexels) {
  const TriangleMesh mesh = coloured_blob();
  std::vector<float> texels(mesh.triangles.size(), 1);
  texels[7] = 1000;
  const RawPages raw = make_raw_pages(mesh, texels, 100);
  ASSERT_EQ(raw.triangles.size(), mesh.triangles.size());
  size_t at = 0;
  for (const PageMesh& page : raw.pages) {
    double sum = 0;
    for (const PageTriangle& triangle : page.triangles) {
      const uint32_t number = raw.triangles[at++];
      sum += texels[number];
      for (int k = 0; k < 3; ++k) {
        const Vec3d& vertex = mesh.vertices[mesh.triangles[number][k]];
        EXPECT_LT((raw.space.to_file(page.positions[triangle[k]]) - vertex).norm(), 1e-5);
      }
    }
    EXPECT_TRUE(sum <= 100 || page.triangles.size() == 1) << sum;
  }
  EXPECT_EQ(at, mesh.triangles.size());
}

TEST(RawPages, VerticesLookAsThoseOfTheWholeMeshInEveryPage) {
  const TriangleMesh mesh = coloured_blob();
  const RawPages raw = make_raw_pages(mesh);
  std::vector<Vec3f> positions;
  for (const Vec3d& vertex : mesh.vertices)
    positions.push_back(((vertex - raw.space.centre) / raw.space.unit).cast<float>());
  const auto normals = vertex_normals(mesh.vertices, mesh.triangles);
  const auto ridges = vertex_ridges(positions, normals, mesh.triangles);
  size_t vertices = 0;
  for (const PageMesh& page : raw.pages) {
    for (size_t i = 0; i < page.positions.size(); ++i, ++vertices) {
      const Rgba8& colour = page.colours[i];  // names the vertex
      const uint32_t v = colour[0] | uint32_t{colour[1]} << 8 | uint32_t{colour[2]} << 16;
      ASSERT_EQ(page.positions[i], positions[v]);
      ASSERT_EQ(page.normals[i], normals[v]);
      ASSERT_EQ(page.ridges[i], ridges[v]);
    }
  }
  EXPECT_GT(vertices, mesh.vertices.size());
}

TEST(RawPages, VerticesThatStandTwiceLookAlike) {
  const TriangleMesh mesh = generate_scan({.kind = "blob", .vertices = 2'000}).value();
  TriangleMesh soup;
  for (const Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<uint32_t>(soup.vertices.size());
    soup.triangles.push_back({first, first + 1, first + 2});
    for (const uint32_t vertex : triangle) soup.vertices.push_back(mesh.vertices[vertex]);
  }
  std::map<Place, std::pair<Vec3f, float>> looks;
  const RawPages raw = make_raw_pages(soup);
  for (const PageMesh& page : raw.pages)
    for (size_t i = 0; i < page.positions.size(); ++i) {
      const std::pair here(page.normals[i], page.ridges[i]);
      const auto [known, is_new] = looks.try_emplace(place_at(page.positions[i]), here);
      ASSERT_EQ(known->second, here);
    }
  EXPECT_EQ(looks.size(), mesh.vertices.size());
}

TEST(RawPages, FewVerticesAreInSeveralPagesThoughTheFileHasTheTrianglesInRows) {
  const TriangleMesh sheet = make_sheet(400, 1, 0.1);
  const RawPages raw = make_raw_pages(sheet);
  size_t vertices = 0;
  for (const PageMesh& page : raw.pages) vertices += page.positions.size();
  EXPECT_LT(double(vertices), 1.12 * double(sheet.vertices.size()));
}

TEST(RawPages, PositionsKeepTheirDetailFarFromTheOrigin) {
  const Vec3d far(5e6, -4e6, 2e5);
  const RawPages near_pages = make_raw_pages(make_test_sphere(Vec3d::Zero(), 0.5));
  const RawPages far_pages = make_raw_pages(make_test_sphere(far, 0.5));
  for (const auto& [raw, centre] : {std::pair(near_pages, Vec3d(Vec3d::Zero())), {far_pages, far}})
    for (const PageMesh& page : raw.pages)
      for (const Vec3f& at : page.positions)
        ASSERT_NEAR((raw.space.to_file(at) - centre).norm(), 0.5, 1e-6);
}

TEST(RawPages, TheBoxLeavesOutVerticesThatNoTriangleReferences) {
  TriangleMesh mesh = make_test_sphere(Vec3d::Zero(), 2);
  mesh.vertices.emplace_back(1000, 1000, 1000);
  EXPECT_NEAR(make_raw_pages(mesh).box.max().maxCoeff(), 2, 1e-12);
}

TEST(RawPages, TheirUnitIsThatOfASessionOnTheMesh) {
  const TriangleMesh mesh = make_test_sphere(Vec3d(1, 2, 3), 2);
  const GridFrame frame = make_grid_frame({-1, 0, 1}, {3, 4, 5}, kDepthMin);
  const PageGrid grid = {frame.origin, frame.cell_size * frame.cells_per_side()};
  const PageSpace session = make_page_space(grid, kDepthMin);
  const PageSpace raw = make_raw_pages(mesh).space;
  EXPECT_NEAR(raw.unit, session.unit, 1e-3 * session.unit);
  EXPECT_NEAR((raw.centre - session.centre).norm(), 0, 1e-3 * session.unit);
}

TEST(RawPages, AMeshAtOnePointHasAUnit) {
  TriangleMesh mesh;
  mesh.vertices.assign(3, Vec3d(1, 2, 3));
  mesh.triangles = {{0, 1, 2}};
  EXPECT_GT(make_raw_pages(mesh).space.unit, 0);
}

TEST(RawPages, ATriangleThatNamesAVertexTwiceIsKept) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 1, 2}};
  const RawPages raw = make_raw_pages(mesh);
  ASSERT_EQ(raw.pages.size(), 1u);
  EXPECT_EQ(raw.pages[0].triangles.size(), 2u);
  EXPECT_EQ(raw.pages[0].positions.size(), 3u);
}

TEST(RawPages, ARendererShowsAllOfThem) {
  const TriangleMesh mesh = make_test_sphere(Vec3d(1, 2, 3), 2);
  const RawPages raw = make_raw_pages(mesh);
  NullPageRenderer renderer;
  const std::vector<PatchRange> patches = upload_pages(raw, renderer).value();
  size_t triangles = 0;
  for (const PatchRange& patch : patches) triangles += patch.count;
  EXPECT_EQ(triangles, mesh.triangles.size());
  EXPECT_EQ(renderer.page(patches.back().slot).positions, raw.pages.back().positions);
}

}  // namespace
}  // namespace burnish

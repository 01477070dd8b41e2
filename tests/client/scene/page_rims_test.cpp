#include "client/scene/page_rims.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"

namespace burnish {
namespace {

TEST(PageRims, EveryBorderVertexIsInAGroupAndAllOfAGroupAreOnePoint) {
  const SplitMesh split =
      split_into_pages(generate_scan({.kind = "blob", .vertices = 4000}).value(), 700);
  std::vector<PageMesh> meshes;
  std::vector<PageRim> rims;
  size_t borders = 0;
  for (const Page& page : split.pages) {
    meshes.push_back(make_page_mesh(page, split.grid));
    rims.push_back(find_rim(meshes.back(), {{{0, 0, uint32_t(page.triangles.size())}}}));
    borders += page.border_vertices;
  }
  std::vector<RimmedPage> pages;
  for (size_t p = 0; p < meshes.size(); ++p) pages.push_back({&meshes[p], &rims[p]});
  const Groups<RimPlace> groups = group_rims(pages);
  EXPECT_EQ(groups.item.size(), borders);
  const auto vertex_of = [&](const RimPlace& place) {
    return split.vertices[place.page][rims[place.page][place.index]];
  };
  for (size_t g = 0; g < groups.count(); ++g) {
    ASSERT_GE(groups[g].size(), 2u);  // border vertices are those of several pages
    for (const RimPlace& place : groups[g]) ASSERT_EQ(vertex_of(place), vertex_of(groups[g][0]));
  }
}

TEST(PageRims, ARimOfDrawnPatchesIsBetweenThemAndTheOthers) {
  // Two triangles on each side of an edge of three vertices; the first two are drawn.
  PageMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {-1, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}, {1, 0, 4}, {2, 1, 4}};
  const std::vector<PatchRange> drawn = {{7, 0, 2}};
  const PageRim rim = find_rim(mesh, drawn);
  EXPECT_EQ(rim, (PageRim{0, 1, 2}));
  const auto sums = sum_rim_normals(mesh.positions, triangles_at_rim(mesh, drawn, rim), rim);
  for (const Vec3f& sum : sums) EXPECT_LT((sum.normalized() - Vec3f::UnitZ()).norm(), 1e-6);
  EXPECT_NEAR(sums[1].norm(), 2, 1e-4) << "two right angles";
  EXPECT_TRUE(find_rim(mesh, {{{7, 0, 4}}}).empty());
}

TEST(PageRims, TrianglesAtTheRimAreDrawnAndHaveARimVertex) {
  PageMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 5}, {0, 1, 3}};
  const std::vector<PatchRange> drawn = {{0, 0, 1}, {0, 2, 1}};
  EXPECT_EQ(triangles_at_rim(mesh, drawn, {0}), (std::vector<PageTriangle>{{0, 1, 2}}));
}

TEST(PageRims, PagesThatShareNoPointHaveGroupsOfOne) {
  PageMesh one, other;
  one.positions = {{0, 0, 0}, {1, 0, 0}};
  other.positions = {{0, 0, 1}};
  const PageRim rim = {0, 1}, other_rim = {0};
  const std::vector<RimmedPage> pages = {{&one, &rim}, {&other, &other_rim}};
  const Groups<RimPlace> groups = group_rims(pages);
  EXPECT_EQ(groups.count(), 3u);
  EXPECT_EQ(groups.item.size(), 3u);
  EXPECT_EQ(group_rims({}).count(), 0u);
}

}  // namespace
}  // namespace burnish

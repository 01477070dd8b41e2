#include "server/prepare/pages/build_pages.h"

#include <fstream>
#include <iterator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mesh/statistics/statistics.h"
#include "server/prepare/pages/page_vertices.h"
#include "tests/common/split_vertices.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/pages/pages_test_meshes.h"
#include "tests/server/prepare/pages/read_pages.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class BuildPages : public testing::Test {
 protected:
  ReadPages pages_of(const TriangleMesh& mesh, const PageTexels& texels = {}) {
    const Status status = build_pages_of(mesh, folder_ / "scan.pages", {}, {}, &report_, texels);
    EXPECT_TRUE(status.is_ok()) << status.to_string();
    auto read = read_pages(folder_ / "scan.pages");
    EXPECT_TRUE(read.is_ok()) << read.status().to_string();
    return std::move(read).value();
  }
  TemporaryFolder folder_;
  PagesReport report_;
};

uint64_t triangles_of(const ReadPages& read, int level) {
  uint64_t triangles = 0;
  for (const Page& page : read.pages)
    if (read.directory.head.level_of(page.id) == level) triangles += page.triangles.size();
  return triangles;
}

// Corner positions of a triangle, from its least one on.
using Corners = std::array<std::array<int, 3>, 3>;

Corners corners_of(const std::array<Vec3i, 3>& places) {
  Corners corners;
  for (int i = 0; i < 3; ++i) corners[i] = {places[i].x(), places[i].y(), places[i].z()};
  std::ranges::rotate(corners, std::ranges::min_element(corners));
  return corners;
}

std::multiset<Corners> level_0_of(const ReadPages& read) {
  std::multiset<Corners> all;
  for (const Page& page : read.pages)
    if (read.directory.head.level_of(page.id) == 0)
      for (const PageTriangle& t : page.triangles)
        all.insert(corners_of({page.positions[t[0]], page.positions[t[1]], page.positions[t[2]]}));
  return all;
}

std::multiset<Corners> corners_of(const TriangleMesh& mesh) {
  const MeshStatistics statistics = compute_statistics(mesh);
  const PageVertices placed =
      place_vertices({mesh.vertices, mesh.triangles, mesh.colours, statistics}, {});
  std::multiset<Corners> all;
  for (const Triangle& t : mesh.triangles)
    all.insert(
        corners_of({placed.positions[t[0]], placed.positions[t[1]], placed.positions[t[2]]}));
  return all;
}

TEST_F(BuildPages, EveryLevelHasAtMostThreeQuartersOfTheFinerOneDownToOnePage) {
  const ReadPages read = pages_of(scan_of_kind("tablet", 30'000));
  ASSERT_GE(read.level_count(), 4);
  for (int level = 1; level < read.level_count(); ++level)
    EXPECT_LE(triangles_of(read, level), 0.75 * triangles_of(read, level - 1));
  EXPECT_EQ(read.directory.head.level_pages.back(), 1u);
}

TEST_F(BuildPages, SmallPagesOfLargePicturesAreJoinedBeforeTheyLoseTriangles) {
  const TriangleMesh mesh = scan_of_kind("blob", 2'000);
  const std::vector<float> texels(mesh.triangles.size(), 100);
  const ReadPages read = pages_of(mesh, {texels, 1000});
  EXPECT_EQ(level_0_of(read), corners_of(mesh));
  EXPECT_GE(read.directory.head.level_pages.front(), mesh.triangles.size() / 10);
  EXPECT_EQ(read.directory.head.level_pages[1], pages_of(mesh).directory.head.level_pages.front());
  EXPECT_EQ(triangles_of(read, 1), mesh.triangles.size());
}

TEST_F(BuildPages, ABoxOfTwelveTrianglesMayHaveAPageForEach) {
  TriangleMesh box;
  for (int corner = 0; corner < 8; ++corner)
    box.vertices.push_back({double(corner & 1), double(corner >> 1 & 1), double(corner >> 2)});
  const std::array<std::array<uint32_t, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : sides) {
    box.triangles.push_back({a, b, c});
    box.triangles.push_back({a, c, d});
  }
  const std::vector<float> texels(box.triangles.size(), 1e6f);
  const ReadPages read = pages_of(box, {texels, 1000});
  EXPECT_EQ(read.directory.head.level_pages, (std::vector<uint32_t>{12, 1}));
  EXPECT_EQ(level_0_of(read), corners_of(box));
  EXPECT_EQ(triangles_of(read, 1), box.triangles.size());
}

TEST_F(BuildPages, Level0IsTheScan) {
  const TriangleMesh mesh = scan_of_kind("tablet", 20'000);
  const ReadPages read = pages_of(mesh);
  EXPECT_EQ(level_0_of(read), corners_of(mesh));
}

TEST_F(BuildPages, ATornSurfaceHasTheVerticesAndNormalsOfTheWholeOne) {
  const TriangleMesh mesh = scan_of_kind("blob", 20'000);
  const ReadPages whole = pages_of(mesh), pieces = pages_of(as_soup(mesh));
  const size_t pages = whole.directory.head.level_begin(1);
  ASSERT_EQ(pieces.directory.head.level_begin(1), pages);
  for (size_t page = 0; page < pages; ++page) {
    EXPECT_EQ(pieces.pages[page].triangles, whole.pages[page].triangles);
    EXPECT_EQ(pieces.pages[page].positions, whole.pages[page].positions);
    EXPECT_EQ(pieces.pages[page].normals, whole.pages[page].normals);
  }
}

// The two sides of a sheet that is there twice, back to back, have opposite normals.
TEST_F(BuildPages, SidesThatTouchBackToBackStayApartAtLevel0) {
  const TriangleMesh sheet = scan_of_kind("sheet", 5'000);
  TriangleMesh both = sheet;
  for (const Vec3d& vertex : sheet.vertices) both.vertices.push_back(vertex);
  const auto count = static_cast<uint32_t>(sheet.vertices.size());
  for (const Triangle& t : sheet.triangles)
    both.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
  std::set<std::pair<std::array<int, 3>, bool>> sides;
  const ReadPages read = pages_of(both);
  EXPECT_EQ(level_0_of(read), corners_of(both));
  for (const Page& page : read.pages)
    if (read.directory.head.level_of(page.id) == 0)
      for (uint32_t v = 0; v < page.border_vertices; ++v) {
        const Vec3i& p = page.positions[v];
        sides.insert({{p.x(), p.y(), p.z()}, page.normals[v].z() > 0});
        EXPECT_GT(std::abs(page.normals[v].z()), 0.1);
      }
  for (const auto& [place, is_up] : sides) EXPECT_TRUE(sides.contains({place, !is_up}));
}

TEST_F(BuildPages, AllVerticesOfOnePlaceAreJoinedAboveLevel0) {
  const TriangleMesh mesh = scan_of_kind("soup", 60'000);
  const ReadPages read = pages_of(mesh);
  EXPECT_EQ(level_0_of(read), corners_of(mesh));
  for (const Page& page : read.pages)
    if (read.directory.head.level_of(page.id) > 0) {
      EXPECT_LT(page.positions.size(), 1.5 * page.triangles.size());
    }
}

TEST_F(BuildPages, TheBytesAreTheSameForAnyNumberOfThreads) {
  TriangleMesh mesh = scan_of_kind("fan", 40'000);
  mesh.colours.resize(mesh.vertices.size(), {1, 2, 3, 255});
  ASSERT_TRUE(build_pages_of(mesh, folder_ / "one.pages", {.threads = 1}).is_ok());
  for (const int threads : {2, 4}) {
    ASSERT_TRUE(build_pages_of(mesh, folder_ / "several.pages", {.threads = threads}).is_ok());
    EXPECT_TRUE(content_of(folder_ / "one.pages") == content_of(folder_ / "several.pages"));
  }
}

TEST_F(BuildPages, TheBytesAreTheSameWithAllArraysInFiles) {
  for (const char* kind : {"blob", "soup"}) {
    TriangleMesh mesh = scan_of_kind(kind, 40'000);
    mesh.colours.resize(mesh.vertices.size(), {1, 2, 3, 255});
    ASSERT_TRUE(build_pages_of(mesh, folder_ / "memory.pages").is_ok());
    const PagesOptions in_files = {.space = ScratchSpace(folder_ / "", 0)};
    ASSERT_TRUE(build_pages_of(mesh, folder_ / "files.pages", in_files).is_ok());
    EXPECT_EQ(in_files.space.memory_bytes(), 0u);
    EXPECT_TRUE(content_of(folder_ / "memory.pages") == content_of(folder_ / "files.pages"));
  }
}

// One page whose error stands out brings all finer pages of its place into every picture.
TEST_F(BuildPages, NoErrorOfTheFinestLevelStandsOut) {
  const ReadPages read = pages_of(scan_of_kind("tablet", 400'000));
  std::vector<float> errors;
  for (PageId page = 0; page < read.directory.head.level_begin(1); ++page)
    errors.push_back(read.directory.entries[page].bounds.error);
  std::ranges::sort(errors);
  EXPECT_LT(errors.back(), 2 * errors[errors.size() / 2]);
}

TEST_F(BuildPages, ErrorAndEdgeRiseTowardsTheRoot) {
  const ReadPages read = pages_of(scan_of_kind("blob", 30'000));
  for (PageId page = 0; page < read.directory.head.root(); ++page) {
    const PageBounds& bounds = read.directory.entries[page].bounds;
    EXPECT_GT(bounds.edge, 0);
    for (const PageId coarser : read.directory.coarser[page]) {
      EXPECT_GE(read.directory.entries[coarser].bounds.error, bounds.error);
      EXPECT_GE(read.directory.entries[coarser].bounds.edge, bounds.edge);
    }
  }
}

TEST_F(BuildPages, TheErrorBoundsHowFarASphereIsLeft) {
  const ReadPages read = pages_of(scan_of_kind("icosphere", 40'000));
  const PageGrid& grid = read.directory.head.grid;
  for (const Page& page : read.pages) {
    float finer_error = 0;
    for (const PagePatch& patch : page.patches)
      if (patch.finer != kNoPage)
        finer_error = std::max(finer_error, read.directory.entries[patch.finer].bounds.error);
    for (const PageTriangle& t : page.triangles) {
      const Vec3d centroid =
          (grid.to_file(page.positions[t[0]]) + grid.to_file(page.positions[t[1]]) +
           grid.to_file(page.positions[t[2]])) /
          3;
      EXPECT_NEAR(centroid.norm(), 1, finer_error + 1e-3);
    }
  }
}

TEST_F(BuildPages, TheSphereOfAPageHoldsAllItsVertices) {
  const ReadPages read = pages_of(scan_of_kind("tablet", 20'000));
  const PageGrid& grid = read.directory.head.grid;
  for (const Page& page : read.pages) {
    const PageBounds& bounds = read.directory.entries[page.id].bounds;
    for (const Vec3i& position : page.positions) {
      const Vec3d place = grid.to_file(position) - grid.origin;
      EXPECT_LE((place - bounds.centre.cast<double>()).norm(), bounds.radius);
    }
  }
}

TEST_F(BuildPages, BorderVerticesHaveOneNormalInAllPagesOfTheirLevel) {
  const ReadPages read = pages_of(scan_of_kind("tablet", 20'000));
  std::map<std::array<int, 4>, Vec3f> normals;
  size_t compared = 0;
  for (const Page& page : read.pages)
    for (uint32_t v = 0; v < page.border_vertices; ++v) {
      const Vec3i& p = page.positions[v];
      const int level = read.directory.head.level_of(page.id);
      const auto [found, is_new] =
          normals.try_emplace({level, p.x(), p.y(), p.z()}, page.normals[v]);
      EXPECT_EQ(found->second, page.normals[v]);
      compared += !is_new;
    }
  EXPECT_GT(compared, 500u);
}

TEST_F(BuildPages, NormalsOfASpherePointAwayFromItsCentreAtEveryLevel) {
  const ReadPages read = pages_of(scan_of_kind("icosphere", 40'000));
  for (const Page& page : read.pages)
    for (size_t v = 0; v < page.normals.size(); ++v) {
      const Vec3d outwards = read.directory.head.grid.to_file(page.positions[v]).normalized();
      EXPECT_GT(outwards.dot(page.normals[v].cast<double>()), 0.995);
    }
}

TEST_F(BuildPages, CoarsePagesHaveTheMeanColour) {
  TriangleMesh mesh = scan_of_kind("sheet", 40'000);
  std::vector<Rgba8>& colours = mesh.colours;
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    colours.push_back(v % 2 == 0 ? Rgba8{200, 0, 10, 255} : Rgba8{100, 0, 10, 255});
  const ReadPages read = pages_of(mesh);
  const Page& root = read.pages.back();
  ASSERT_EQ(root.colours.size(), root.positions.size());
  for (const Rgba8& colour : root.colours) {
    EXPECT_NEAR(colour[0], 150, 20);
    EXPECT_EQ(colour[1], 0);
    EXPECT_EQ(colour[2], 10);
    EXPECT_EQ(colour[3], 255);
  }
}

TEST_F(BuildPages, AScanThatFitsAPageIsItsOwnRoot) {
  const TriangleMesh mesh = scan_of_kind("blob", 1'000);
  const ReadPages read = pages_of(mesh);
  EXPECT_EQ(read.pages.size(), 1u);
  EXPECT_EQ(level_0_of(read), corners_of(mesh));
}

TEST_F(BuildPages, OneTriangleIsAPage) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(pages_of(mesh).pages.at(0).triangles.size(), 1u);
}

TEST_F(BuildPages, TrianglesThatNameAVertexTwiceAreLeftOut) {
  TriangleMesh mesh = scan_of_kind("sheet", 10'000);
  const size_t triangles = mesh.triangles.size();
  mesh.triangles.insert(mesh.triangles.begin() + 1000, {{5, 5, 6}, {7, 8, 7}, {9, 9, 9}});
  EXPECT_EQ(triangles_of(pages_of(mesh), 0), triangles);
}

TEST_F(BuildPages, SurveysFarFromTheOriginHaveTheStepsThatTheyHaveAtIt) {
  TriangleMesh mesh = scan_of_kind("sheet", 20'000);
  const ReadPages near = pages_of(mesh);
  for (Vec3d& vertex : mesh.vertices) vertex += Vec3d(5e6, -4e6, 300);
  const ReadPages far = pages_of(mesh);
  EXPECT_EQ(near.directory.head.grid.bits, far.directory.head.grid.bits);
  EXPECT_EQ(near.directory.head.level_pages, far.directory.head.level_pages);
  EXPECT_EQ(level_0_of(far), corners_of(mesh));
}

TEST_F(BuildPages, HugeCoordinatesAreNoTrouble) {
  TriangleMesh mesh = scan_of_kind("blob", 20'000);
  for (Vec3d& vertex : mesh.vertices) vertex *= 1e17;
  const ReadPages read = pages_of(mesh);
  EXPECT_EQ(read.directory.head.level_pages.back(), 1u);
  EXPECT_TRUE(std::isfinite(read.directory.entries[0].bounds.error));
}

TEST_F(BuildPages, SurfaceThatIsOnePointOfTheGridKeepsATriangleAPage) {
  TriangleMesh mesh = scan_of_kind("blob", 20'000);
  for (Vec3d& vertex : mesh.vertices) vertex *= 1e-9;
  const auto far = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  mesh.triangles.push_back({far, far + 1, far + 2});
  const ReadPages read = pages_of(mesh);
  EXPECT_EQ(read.directory.head.level_pages.back(), 1u);
  EXPECT_EQ(triangles_of(read, 0), mesh.triangles.size());
}

struct Trouble {
  const char* name;
  TriangleMesh mesh;
  uint64_t torn_pages_max;
};

TEST_F(BuildPages, TroublesomeScansReachOnePageToo) {
  const Trouble troubles[] = {
      {"loose triangles", loose_triangles(20'000), 0},
      {"small components", small_components(5'000), 0},
      {"duplicates", with_duplicates(scan_of_kind("blob", 20'000)), 0},
      {"overlapping unshared triangles", scan_of_kind("soup", 60'000), 0},
      {"tangle", tangle(400, 30'000), 1000},
  };
  for (const Trouble& trouble : troubles) {
    SCOPED_TRACE(trouble.name);
    const ReadPages read = pages_of(trouble.mesh);
    EXPECT_EQ(read.directory.head.level_pages.back(), 1u);
    uint64_t torn = 0;
    for (const PagesReport::Level& level : report_.levels) torn += level.torn_pages;
    EXPECT_LE(torn, trouble.torn_pages_max);
  }
}

TEST_F(BuildPages, CancellingLeavesNoFile) {
  int reports = 0;
  const auto progress = [&](std::string_view, double fraction) {
    EXPECT_LE(fraction, 1);
    return ++reports < 3;
  };
  const Status status =
      build_pages_of(scan_of_kind("blob", 20'000), folder_ / "scan.pages", {}, progress);
  EXPECT_EQ(status.code(), StatusCode::kCancelled);
  EXPECT_EQ(folder_.file_count(), 0u);
}

// The scan's vertices meet, so that all loops run.
TEST_F(BuildPages, CanBeCancelledWheneverItReportsAndEachOfItsLoopsDoes) {
  constexpr int kLoops = 30;
  const TriangleMesh scan = as_soup(scan_of_kind("blob", 6'000));
  for (int until = 1;; ++until) {
    int left = until;
    const Status status = build_pages_of(scan, folder_ / "scan.pages", {},
                                         [&](std::string_view, double) { return --left > 0; });
    if (left > 0) {  // there were fewer reports: loops also report by the clock
      EXPECT_TRUE(status.is_ok()) << status.message();
      EXPECT_GT(until, kLoops);
      break;
    }
    ASSERT_EQ(status.code(), StatusCode::kCancelled) << until;
    EXPECT_EQ(left, 0) << "went on after report " << until;
  }
}

class NoBudget : public PreparationBudget {
 public:
  uint64_t memory_bytes_max() const override { return 5; }
  Status ask(const PreparationNeed&) override { return resource_exhausted("the limit is 5 B"); }
};

TEST_F(BuildPages, ABudgetThatIsTooSmallIsNamed) {
  NoBudget budget;
  const Status status =
      build_pages_of(scan_of_kind("blob", 20'000), folder_ / "scan.pages", {0, &budget});
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("MiB"));
  EXPECT_THAT(status.message(), HasSubstr("the limit is 5 B"));
}

}  // namespace
}  // namespace burnish

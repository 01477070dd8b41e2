#include "client/scene/page_surface.h"

#include <map>

#include <gtest/gtest.h>

#include "client/scene/mesh_normals.h"
#include "client/scene/null_page_renderer.h"
#include "client/scene/ridges.h"
#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

double degrees_apart(const Vec3f& a, const Vec3f& b) {
  const Vec3d u = a.cast<double>(), v = b.cast<double>();
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

/// A rough mesh in pages, page i in slot i, that strong edits move.
class JoinedPages : public testing::Test {
 protected:
  void SetUp() override {
    surface_.open(space_);
    ASSERT_TRUE(surface_.reserve(static_cast<uint32_t>(split_.pages.size() + 1)).is_ok());
    for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) put(slot);
  }

  void put(uint32_t slot) {
    ASSERT_TRUE(surface_.put(slot, make_page_mesh(split_.pages[slot], split_.grid)).is_ok());
  }

  void move(uint32_t slot, uint32_t seed) {
    surface_.move(slot, random_moves(split_.pages[slot].positions, seed));
  }
  void move_all(uint32_t seed) {
    for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) move(slot, seed);
  }

  std::vector<PatchRange> all() const {
    std::vector<PatchRange> patches;
    for (uint32_t slot = 0; slot < split_.pages.size(); ++slot)
      patches.push_back({slot, 0, uint32_t(split_.pages[slot].triangles.size())});
    return patches;
  }

  void draw(const std::vector<PatchRange>& patches) {
    ASSERT_TRUE(surface_.draw({}, {32, 24}, {}, patches).is_ok());
  }

  // The normals of the moved mesh as a whole.
  std::vector<Vec3f> expected_normals() const {
    TriangleMesh whole = split_.rounded;
    for (uint32_t slot = 0; slot < split_.pages.size(); ++slot)
      for (size_t v = 0; v < split_.vertices[slot].size(); ++v)
        whole.vertices[split_.vertices[slot][v]] = displaced_position(surface_.at(slot), v);
    return vertex_normals(whole.vertices, whole.triangles);
  }

  void expect_normals_of_the_whole() const {
    const std::vector<Vec3f> expected = expected_normals();
    for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) {
      const auto normals = renderer_.normals(slot);
      ASSERT_EQ(normals.size(), split_.vertices[slot].size());
      for (size_t v = 0; v < normals.size(); ++v)
        ASSERT_LT(degrees_apart(normals[v], expected[split_.vertices[slot][v]]), 0.1);
    }
  }

  const SplitMesh split_ =
      split_into_pages(generate_scan({.kind = "blob", .vertices = 4000}).value(), 700);
  const PageSpace space_ = make_page_space(split_.grid, 6);
  NullPageRenderer renderer_;
  PageSurface surface_{renderer_};
};

TEST_F(JoinedPages, NormalsAreThoseOfTheMovedMeshAsAWhole) {
  for (const uint32_t seed : {1u, 2u}) {
    move_all(seed);
    draw(all());
    expect_normals_of_the_whole();
  }
}

TEST_F(JoinedPages, RidgesAreThoseOfTheJoinedNormalsAndTheMeanAtBorders) {
  move_all(1);
  draw(all());
  std::vector<float> sums(split_.rounded.vertices.size());
  std::vector<int> counts(sums.size());
  for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) {
    const DisplacedPage page = surface_.at(slot);
    const MovedPage moved = displace(page.mesh, page.displacements, space_.cell_size);
    const auto own = vertex_ridges(moved.positions, renderer_.normals(slot), page.mesh.triangles);
    for (size_t v = 0; v < own.size(); ++v) {
      sums[split_.vertices[slot][v]] += own[v];
      ++counts[split_.vertices[slot][v]];
    }
  }
  for (uint32_t slot = 0; slot < split_.pages.size(); ++slot)
    for (size_t v = 0; v < split_.vertices[slot].size(); ++v) {
      const uint32_t vertex = split_.vertices[slot][v];
      ASSERT_NEAR(renderer_.ridges(slot)[v], sums[vertex] / float(counts[vertex]), 1e-6);
    }
}

TEST_F(JoinedPages, SharedVerticesHaveTheSameBitsInAllPages) {
  move_all(1);
  draw(all());
  std::vector<Vec3f> first(split_.rounded.vertices.size(), Vec3f::Zero());
  std::map<uint32_t, float> ridges;
  size_t shared = 0;
  for (uint32_t slot = 0; slot < split_.pages.size(); ++slot)
    for (size_t v = 0; v < split_.vertices[slot].size(); ++v) {
      Vec3f& normal = first[split_.vertices[slot][v]];
      if (normal.isZero(0)) normal = renderer_.normals(slot)[v];
      shared += v < split_.pages[slot].border_vertices;
      ASSERT_EQ(renderer_.normals(slot)[v], normal);
      float& ridge =
          ridges.try_emplace(split_.vertices[slot][v], renderer_.ridges(slot)[v]).first->second;
      ASSERT_EQ(renderer_.ridges(slot)[v], ridge);
    }
  EXPECT_GT(shared, 500u);
}

TEST_F(JoinedPages, ASecondPictureOfTheSamePagesSendsNothing) {
  move_all(1);
  draw(all());
  const uint64_t moves = renderer_.move_count();
  EXPECT_EQ(moves, split_.pages.size());
  draw(all());
  EXPECT_EQ(renderer_.move_count(), moves);
}

TEST_F(JoinedPages, WithoutAnEditNormalsStayAsThePagesHaveThem) {
  draw(all());
  for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) {
    EXPECT_TRUE(std::ranges::equal(renderer_.normals(slot), surface_.at(slot).mesh.normals));
    for (const Vec3f& move : renderer_.displacements(slot)) EXPECT_EQ(move, Vec3f::Zero());
  }
}

TEST_F(JoinedPages, ABorderTurnsInThePageBesideTheMovedOneToo) {
  // Only inner vertices of page 0 move, so its neighbours stay in place.
  std::vector<Vec3f> moves = random_moves(split_.pages[0].positions, 1);
  std::fill_n(moves.begin(), split_.pages[0].border_vertices, Vec3f::Zero());
  surface_.move(0, moves);
  draw(all());
  const std::vector<Vec3f> expected = expected_normals();
  double largest = 0;
  for (uint32_t slot = 1; slot < split_.pages.size(); ++slot) {
    const auto normals = renderer_.normals(slot);
    for (size_t v = 0; v < normals.size(); ++v) {
      ASSERT_LT(degrees_apart(normals[v], expected[split_.vertices[slot][v]]), 0.1);
      largest = std::max(largest, degrees_apart(normals[v], surface_.at(slot).mesh.normals[v]));
    }
  }
  EXPECT_GT(largest, 5);
}

TEST_F(JoinedPages, APageThatIsDrawnAgainIsJoinedAgain) {
  move_all(1);
  draw(all());
  std::vector<PatchRange> fewer = all();
  fewer.erase(fewer.begin() + 2);
  draw(fewer);
  move_all(2);
  draw(fewer);
  draw(all());
  expect_normals_of_the_whole();
}

TEST_F(JoinedPages, APagePutAnewIsNotMovedUntilItIsTold) {
  move_all(1);
  draw(all());
  put(2);
  move(2, 1);
  draw(all());
  expect_normals_of_the_whole();
  surface_.open(space_);
  for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) put(slot);
  draw({});
  draw(all());
  EXPECT_TRUE(std::ranges::equal(renderer_.normals(2), surface_.at(2).mesh.normals));
}

TEST_F(JoinedPages, PatchesOfACoarserPageAreJoinedWithTheFinerPagesBesideThem) {
  // The coarser page has pages 0 and 1 in a patch each; it is drawn in the place of page 0.
  const auto first = uint32_t(split_.pages[0].triangles.size());
  Page coarser;
  std::vector<uint32_t> vertices;  // in the mesh
  const auto place_of = [&](uint32_t v) {
    const auto found = std::ranges::find(vertices, v);
    const auto place = static_cast<uint16_t>(found - vertices.begin());
    if (found != vertices.end()) return place;
    vertices.push_back(v);
    coarser.positions.push_back(split_.grid.quantise(split_.rounded.vertices[v]));
    return place;
  };
  for (const uint32_t page : {0u, 1u})
    for (const auto& [a, b, c] : split_.pages[page].triangles)
      coarser.triangles.push_back({place_of(split_.vertices[page][a]),
                                   place_of(split_.vertices[page][b]),
                                   place_of(split_.vertices[page][c])});
  coarser.border_vertices = uint32_t(coarser.positions.size());
  const auto still = vertex_normals(split_.rounded.vertices, split_.rounded.triangles);
  for (const uint32_t v : vertices) coarser.normals.push_back(still[v]);
  const auto slot = uint32_t(split_.pages.size());
  ASSERT_TRUE(surface_.put(slot, make_page_mesh(coarser, split_.grid)).is_ok());
  move_all(1);
  surface_.move(slot, random_moves(coarser.positions, 1));
  std::vector<PatchRange> patches = all();
  patches[0] = {slot, 0, first};
  draw(patches);
  const std::vector<Vec3f> expected = expected_normals();
  for (uint32_t v : split_.vertices[0]) {
    const auto place = size_t(std::ranges::find(vertices, v) - vertices.begin());
    ASSERT_LT(degrees_apart(renderer_.normals(slot)[place], expected[v]), 0.1);
  }
  for (size_t v = 0; v < split_.vertices[1].size(); ++v)
    ASSERT_LT(degrees_apart(renderer_.normals(1)[v], expected[split_.vertices[1][v]]), 0.1);
}

TEST_F(JoinedPages, ARayHitsTheNearestOfAllTriangles) {
  move_all(3);
  draw(all());
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3d aside(0.1 * (i % 20 - 10), 0.1 * (i / 20 - 10), 0);
    const Ray ray{space_.centre + space_.unit * Vec3d(0.3, 0.2, 5),
                  (Vec3d(0, 0, -5) + aside).normalized()};
    std::optional<SurfaceHit> expected;
    for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) {
      const DisplacedPage page = surface_.at(slot);
      const auto count = static_cast<uint32_t>(page.mesh.triangles.size());
      const auto found = nearest_hit(page, ray, 0, count);
      if (found && (!expected || found->distance < expected->distance)) expected = found;
    }
    const auto found = surface_.hit(ray, false);
    ASSERT_EQ(found.has_value(), expected.has_value()) << i;
    if (!found) continue;
    ++hits;
    EXPECT_EQ(found->point.distance, expected->distance);
    EXPECT_EQ(found->point.original, expected->original);
  }
  EXPECT_GT(hits, 50);
}

}  // namespace
}  // namespace burnish

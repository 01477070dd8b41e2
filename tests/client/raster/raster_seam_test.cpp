#include <gtest/gtest.h>

#include "client/raster/raster_page_renderer.h"
#include "client/scene/page_surface.h"
#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

constexpr ImageSize kSeamSize{400, 300};

/// A grey sphere of many pages around a red one: red shows wherever the grey one is open.
class RasterSeams : public testing::TestWithParam<RasterSampling> {
 protected:
  void SetUp() override {
    TriangleMesh mesh = make_icosphere(4, 1);
    const TriangleMesh inner = make_icosphere(3, 0.75);
    const auto offset = static_cast<uint32_t>(mesh.vertices.size());
    mesh.colours.assign(offset, Rgba8{120, 120, 120, 255});
    mesh.colours.resize(offset + inner.vertices.size(), Rgba8{255, 0, 0, 255});
    mesh.vertices.insert(mesh.vertices.end(), inner.vertices.begin(), inner.vertices.end());
    for (const Triangle& t : inner.triangles)
      mesh.triangles.push_back({offset + t[0], offset + t[1], offset + t[2]});
    split_ = split_into_pages(mesh, 350);
    space_ = make_page_space(split_.grid, 5);
    camera_ = {.target = space_.centre, .distance = 4.5, .scene_radius = 2};
    surface_.open(space_);
    ASSERT_TRUE(surface_.reserve(static_cast<uint32_t>(split_.pages.size())).is_ok());
    for (uint32_t slot = 0; slot < split_.pages.size(); ++slot) {
      meshes_.push_back(make_page_mesh(split_.pages[slot], split_.grid));
      ASSERT_TRUE(surface_.put(slot, meshes_[slot]).is_ok());
      patches_.push_back({slot, 0, static_cast<uint32_t>(meshes_[slot].triangles.size())});
    }
    renderer_.set_sampling(GetParam());
  }

  void move_outer(uint32_t seed) {
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      std::vector<Vec3f> moves = random_moves(split_.pages[slot].positions, seed);
      for (size_t v = 0; v < moves.size(); ++v)
        if (meshes_[slot].colours[v][1] == 0) moves[v] = Vec3f::Zero();
      surface_.move(slot, moves);
    }
  }

  int count_red() {
    EXPECT_TRUE(
        surface_.draw(camera_, kSeamSize, {.colouring = Colouring::kScan}, patches_).is_ok());
    const Image& image = renderer_.picture();
    int red = 0;
    for (size_t i = 0; i < image.rgb.size(); i += 3) red += image.rgb[i] > image.rgb[i + 1] + 25;
    return red;
  }

  SplitMesh split_;
  PageSpace space_;
  std::vector<PageMesh> meshes_;
  std::vector<PatchRange> patches_;
  Camera camera_;
  RasterPageRenderer renderer_{2};
  PageSurface surface_{renderer_};
};

TEST_P(RasterSeams, NoPixelShowsThroughABorderAtAnyZoom) {
  for (const double zoom : {0.02, 0.2, 1.0, 3.0, 30.0, 1000.0}) {
    camera_.zoom = zoom;
    for (uint32_t turn = 0; turn < 7; ++turn) {
      camera_.azimuth_degrees = 53 * turn;
      camera_.elevation_degrees = 11.0 * turn - 30;
      EXPECT_EQ(count_red(), 0) << zoom << " " << turn;
    }
  }
}

TEST_P(RasterSeams, NoPixelShowsThroughABorderUnderRandomDisplacements) {
  for (uint32_t seed = 1; seed <= 12; ++seed) {
    camera_.azimuth_degrees = 37 * seed;
    camera_.elevation_degrees = 11.0 * (seed % 9) - 44;
    move_outer(seed);
    EXPECT_EQ(count_red(), 0) << seed;
  }
}

TEST_P(RasterSeams, NoBackgroundShowsFromWithin) {
  camera_ = {.target = space_.centre, .distance = 0.01, .scene_radius = 4};
  ASSERT_TRUE(renderer_.draw(camera_, kSeamSize, {}, {}).is_ok());
  const Image background = renderer_.picture();
  for (uint32_t turn = 0; turn < 7; ++turn) {
    camera_.azimuth_degrees = 53 * turn;
    camera_.elevation_degrees = 25.0 * turn - 75;
    EXPECT_TRUE(surface_.draw(camera_, kSeamSize, {.faded = true}, patches_).is_ok());
    int open = 0;
    for (size_t i = 0; i < background.rgb.size(); i += 3)
      open += std::equal(&background.rgb[i], &background.rgb[i] + 3, &renderer_.picture().rgb[i]);
    EXPECT_EQ(open, 0) << turn;
  }
}

TEST_P(RasterSeams, APageThatMovesAloneIsSeen) {
  move_outer(1);
  uint32_t front = 0;  // the page whose first vertex is nearest to the eye
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
    if (meshes_[slot].positions[0].z() > meshes_[front].positions[0].z()) front = slot;
  std::vector<Vec3f> moves = random_moves(split_.pages[front].positions, 1);
  for (Vec3f& each : moves) each += Vec3f(0.2f, 0.2f, 0);
  surface_.move(front, moves);
  EXPECT_GT(count_red(), 10);
}

INSTANTIATE_TEST_SUITE_P(Samplings, RasterSeams,
                         testing::Values(RasterSampling::kOne, RasterSampling::kFour));

}  // namespace
}  // namespace burnish

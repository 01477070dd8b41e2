#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/gl/page_stage.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

/// A grey sphere of many pages around a red one: red shows wherever the grey one is open.
class PageCracks : public PageStage {
 protected:
  void SetUp() override {
    PageStage::SetUp();
    show(split_into_pages(two_spheres(), 350));
    ASSERT_EQ(split_.pages.size(), 32u);
  }

  static TriangleMesh two_spheres() {
    TriangleMesh mesh = make_icosphere(4, 1);
    const TriangleMesh inner = make_icosphere(3, 0.75);
    const auto offset = static_cast<uint32_t>(mesh.vertices.size());
    mesh.colours.assign(offset, Rgba8{120, 120, 120, 255});
    mesh.colours.resize(offset + inner.vertices.size(), Rgba8{255, 0, 0, 255});
    mesh.vertices.insert(mesh.vertices.end(), inner.vertices.begin(), inner.vertices.end());
    for (const Triangle& t : inner.triangles)
      mesh.triangles.push_back({offset + t[0], offset + t[1], offset + t[2]});
    return mesh;
  }

  // Moves the outer sphere by up to a cell, so that its triangles change by more than a pixel.
  void move_outer(uint32_t seed) {
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      std::vector<Vec3f> moves = random_moves(split_.pages[slot].positions, seed);
      for (size_t v = 0; v < moves.size(); ++v)
        if (meshes_[slot].colours[v][1] == 0) moves[v] = Vec3f::Zero();
      move(slot, moves);
    }
  }

  int count_red() {
    const Image image = draw({.colouring = Colouring::kScan});
    int red = 0;
    for_each_pixel([&](int x, int y) {
      const uint8_t* rgb = image.pixel(x, y);
      red += rgb[0] > rgb[1] + 25;
    });
    return red;
  }
};

TEST_F(PageCracks, NoPixelShowsThroughABorderUnderRandomDisplacements) {
  EXPECT_EQ(count_red(), 0);
  for (uint32_t seed = 1; seed <= 12; ++seed) {
    camera_.azimuth_degrees = 37 * seed;
    camera_.elevation_degrees = 11.0 * (seed % 9) - 44;
    move_outer(seed);
    EXPECT_EQ(count_red(), 0) << seed;
  }
}

TEST_F(PageCracks, APageThatMovesAloneIsSeen) {
  move_outer(1);
  uint32_t front = 0;  // the page whose first vertex is nearest to the eye
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
    if (meshes_[slot].positions[0].z() > meshes_[front].positions[0].z()) front = slot;
  std::vector<Vec3f> moves = random_moves(split_.pages[front].positions, 1);
  for (Vec3f& each : moves) each += Vec3f(0.2f, 0.2f, 0);
  move(front, moves);
  EXPECT_GT(count_red(), 10);
}

}  // namespace
}  // namespace burnish

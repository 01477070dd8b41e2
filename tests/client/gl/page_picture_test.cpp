#include <gtest/gtest.h>

#include "client/gl/gl_renderer.h"
#include "client/scene/displaced_surface.h"
#include "common/generate/generate.h"
#include "tests/client/gl/page_stage.h"
#include "tests/client/scene/gridded_sphere.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

class PagePicture : public PageStage {
 protected:
  // Draws the same mesh as a whole, in a grid.
  Image draw_whole(const ViewMesh& mesh, const std::vector<Vec3f>& displacements,
                   const DrawStyle& style = {}) {
    const auto whole = std::move(GlRenderer::create()).value();
    EXPECT_TRUE(whole->upload_mesh(mesh).is_ok());
    const IndexRange all{0, displacements.size()};
    EXPECT_TRUE(whole->upload_displacements(displacements, {&all, 1}).is_ok());
    EXPECT_TRUE(whole->draw(camera_, kStageSize, style).is_ok());
    return std::move(whole->read_pixels()).value();
  }

  // Moves all pages as the grid's corners move the whole mesh.
  void move_as(const ViewMesh& mesh, const std::vector<Vec3f>& displacements) {
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      std::vector<Vec3f> moves;
      for (const uint32_t v : split_.vertices[slot]) {
        const Vec3d move = displaced_vertex({mesh, displacements}, v) - original_vertex(mesh, v);
        moves.push_back((move / (space_.unit * space_.cell_size)).cast<float>());
      }
      move(slot, meshes_[slot], moves);
    }
  }

  void move_randomly(uint32_t slot, uint32_t seed) {
    move(slot, meshes_[slot], random_moves(split_.pages[slot].positions, seed));
  }
};

Vec3f page_wave(const Vec3d& corner) {
  return Vec3d(0.6 * std::sin(0.5 * corner.y()), 0.8 * std::cos(0.4 * corner.x()),
               0.05 * corner.x())
      .cast<float>();
}

TEST_F(PagePicture, PagesLookAsTheWholeMeshDoes) {
  struct Case {
    const char* kind;
    uint64_t vertices;
    size_t triangles_max;
    size_t pages;
  };
  for (const Case& each : {Case{"icosphere", 2562, 2560, 2}, Case{"icosphere", 2562, 1280, 4},
                           Case{"tablet", 1500, 1000, 4}, Case{"blob", 4000, 2500, 4}}) {
    SCOPED_TRACE(each.kind);
    show(split_into_pages(generate_scan({each.kind, each.vertices}).value(), each.triangles_max));
    ASSERT_EQ(split_.pages.size(), each.pages);
    const View view = make_gridded_view(split_.rounded, kDepth);
    const ViewMesh whole = make_view_mesh(view);
    const std::vector<Vec3f> none(whole.corner_count, Vec3f::Zero());
    const Image empty = draw({}, {});
    const Image still = draw_whole(whole, none);
    EXPECT_GT(mean_luminance_difference(empty, still), 10);
    EXPECT_LT(mean_luminance_difference(draw(), still), 0.2);
    const std::vector<Vec3f> moves = displace_corners(view, page_wave);
    move_as(whole, moves);
    const Image moved = draw_whole(whole, moves);
    EXPECT_GT(mean_luminance_difference(moved, still), 1);
    EXPECT_LT(mean_luminance_difference(draw(), moved), 1);
  }
}

TEST_F(PagePicture, AllStylesLookAsThoseOfTheWholeMesh) {
  show(split_into_pages(make_icosphere(4, 1), 1280));
  const View view = make_gridded_view(split_.rounded, kDepth);
  const ViewMesh whole = make_view_mesh(view);
  const std::vector<Vec3f> moves = displace_corners(view, page_wave);
  move_as(whole, moves);
  const Vec3d front = split_.rounded.vertices[7];
  for (const DrawStyle& style :
       {DrawStyle{.flat = true}, DrawStyle{.wireframe = true}, DrawStyle{.faded = true},
        DrawStyle{.colouring = Colouring::kDisplacement}, DrawStyle{.original = true},
        DrawStyle{.rings = {{front, 0.4, Vec3f(1, 0, 0)}, {front, 1.1, Vec3f(0, 1, 0)}}}})
    EXPECT_LT(mean_luminance_difference(draw(style), draw_whole(whole, moves, style)), 1);
}

TEST_F(PagePicture, TheOriginalIsShownAloneOrOnTheLeftOfTheSplit) {
  show(split_into_pages(make_icosphere(4, 1), 1280));
  const Image still = draw();
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot) move_randomly(slot, 1);
  const Image moved = draw();
  EXPECT_GT(count_different(still, moved), 1000);
  EXPECT_EQ(count_different(still, draw({.original = true})), 0);
  const Image split = draw({.split = 0.5});
  const int middle = split_column(0.5, kStageSize.width);
  int wrong = 0;
  for_each_pixel([&](int x, int y) {
    if (x == middle - 1) return;  // Mesa's scissor lets samples of the next column in
    wrong += !same_pixel(split, x < middle ? still : moved, x, y);
  });
  EXPECT_EQ(wrong, 0);
}

TEST_F(PagePicture, AMovedPageChangesOnlyWhereItWasAndIs) {
  show(split_into_pages(make_icosphere(4, 1), 1280));
  const Image empty = draw({}, {});
  const Image still = draw(), still_alone = draw({}, {all_of(1)});
  move_randomly(1, 5);
  const Image moved = draw(), moved_alone = draw({}, {all_of(1)});
  int changed = 0, outside = 0;
  for_each_pixel([&](int x, int y) {
    if (same_pixel(still, moved, x, y)) return;
    ++changed;
    outside += same_pixel(still_alone, empty, x, y) && same_pixel(moved_alone, empty, x, y);
  });
  EXPECT_GT(changed, 500);
  EXPECT_EQ(outside, 0);
}

TEST_F(PagePicture, PatchesOfAPageAreDrawnApart) {
  show(split_into_pages(make_icosphere(4, 1), 1280));
  const Image whole = draw();
  std::vector<PatchRange> patches;
  for (const PatchRange& page : all()) {
    patches.push_back({page.slot, 0, 100});
    patches.push_back({page.slot, 100, page.count - 100});
  }
  EXPECT_EQ(count_different(whole, draw({}, patches)), 0);
  patches.pop_back();
  EXPECT_GT(count_different(whole, draw({}, patches)), 500);
}

TEST_F(PagePicture, VerticesShowTheirValuesTheirTintsAndTheScansColours) {
  TriangleMesh sphere = make_icosphere(4, 1);
  for (const Vec3d& at : sphere.vertices)
    sphere.colours.push_back(at.y() < 0 ? Rgba8{0, 200, 0, 255} : Rgba8{200, 0, 0, 255});
  show(split_into_pages(sphere, 1280));
  const Image plain = draw();
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
    std::vector<VertexMark> marks;
    for (const Vec3f& at : meshes_[slot].positions)
      marks.push_back({static_cast<int8_t>(at.x() < 0 ? -127 : 127),
                       static_cast<uint8_t>(at.y() < 0 ? 0 : 255)});
    ASSERT_TRUE(renderer_->mark_page(slot, marks).is_ok());
  }
  const Image values = draw({.colouring = Colouring::kCells, .tint = Vec3f(0, 1, 0)});
  const Image colours = draw({.colouring = Colouring::kScan, .tint = Vec3f(1, 0, 0)});
  const int low = 190, high = 110;  // rows
  EXPECT_GT(values.pixel(160, low)[2], values.pixel(160, low)[0] + 40);
  EXPECT_GT(values.pixel(240, low)[0], values.pixel(240, low)[2] + 40);
  EXPECT_GT(values.pixel(200, high)[1], plain.pixel(200, high)[1] + 20);
  EXPECT_GT(colours.pixel(200, low)[1], colours.pixel(200, low)[0] + 40);
  EXPECT_GT(colours.pixel(200, high)[0], colours.pixel(200, high)[1] + 40);
}

}  // namespace
}  // namespace burnish

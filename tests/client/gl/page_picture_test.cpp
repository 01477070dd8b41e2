#include <gtest/gtest.h>

#include "client/scene/raw_pages.h"
#include "common/generate/generate.h"
#include "tests/client/gl/page_stage.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

/// A displacement in cells at a place in PageSpace.
using Field = Vec3f (*)(const Vec3f&);

Vec3f page_wave(const Vec3f& at) {
  return {0.6f * std::sin(8 * at.y()), 0.8f * std::cos(6 * at.x()), 0.5f * at.x()};
}

Vec3f affine(const Vec3f& at) {
  return Eigen::Matrix3f{{3.2f, 4.8f, 0}, {0, -4.8f, 1.6f}, {1.6f, 0, 6.4f}} * at;
}

class PagePicture : public PageStage {
 protected:
  // Draws the mesh with its vertices moved one by one, cut in another way.
  Image draw_whole(Field field, const DrawStyle& style = {}) {
    TriangleMesh moved = split_.rounded;
    for (size_t p = 0; p < meshes_.size(); ++p)
      for (size_t v = 0; v < meshes_[p].positions.size(); ++v) {
        const Vec3f& at = meshes_[p].positions[v];
        moved.vertices[split_.vertices[p][v]] = space_.to_file(at, field(at));
      }
    const auto whole = std::move(GlPageRenderer::create()).value();
    const auto patches = upload_pages(make_raw_pages(moved), *whole).value();
    EXPECT_TRUE(whole->draw(camera_, kStageSize, style, patches).is_ok());
    return std::move(whole->read_pixels()).value();
  }

  void move_by(Field field) {
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      std::vector<Vec3f> moves;
      for (const Vec3f& at : meshes_[slot].positions) moves.push_back(field(at));
      move(slot, moves);
    }
  }

  void move_randomly(uint32_t slot, uint32_t seed) {
    move(slot, random_moves(split_.pages[slot].positions, seed));
  }
};

Vec3f unmoved(const Vec3f&) {
  return Vec3f::Zero();
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
    const Image empty = draw({}, {});
    const Image still = draw_whole(unmoved);
    EXPECT_GT(mean_luminance_difference(empty, still), 10);
    EXPECT_LT(mean_luminance_difference(draw(), still), 0.2);
    for (const Field field : {page_wave, affine}) {
      move_by(field);
      const Image moved = draw_whole(field);
      EXPECT_GT(mean_luminance_difference(moved, still), 1);
      EXPECT_LT(mean_luminance_difference(draw(), moved), 0.2);
    }
  }
}

TEST_F(PagePicture, FlatFadedAndEdgesLookAsThoseOfTheWholeMesh) {
  show(split_into_pages(make_icosphere(4, 1), 1280));
  move_by(page_wave);
  const Image plain = draw();
  for (const DrawStyle& style :
       {DrawStyle{.flat = true}, DrawStyle{.wireframe = true}, DrawStyle{.faded = true}}) {
    const Image styled = draw(style);
    EXPECT_LT(mean_luminance_difference(styled, draw_whole(page_wave, style)), 1);
    EXPECT_GT(count_different(styled, plain), 1000);
  }
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
  // Past the surface, which would turn the normals of the pages beside it.
  const std::vector<Vec3f> moves = random_moves(split_.pages[1].positions, 5);
  const MovedPage page = displace(meshes_[1], moves, space_.cell_size);
  ASSERT_TRUE(renderer_->move_page(1, moves, page.normals, meshes_[1].ridges).is_ok());
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

TEST_F(PagePicture, AnOverlayColoursAndHatchesAndNoTintCoversTheHatch) {
  show(split_into_pages(make_icosphere(4, 1), 1280));
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
    std::vector<VertexMark> marks;
    for (const Vec3f& at : meshes_[slot].positions) {
      const bool is_left = at.x() < 0;
      const std::optional<uint32_t> green = is_left ? std::optional(0x20c020U) : std::nullopt;
      marks.push_back({0, 255, packed_overlay(green, !is_left)});
    }
    ASSERT_TRUE(renderer_->mark_page(slot, marks).is_ok());
  }
  const Image red = draw({.tint = Vec3f(1, 0, 0)});
  int most_blue = -255, least_blue = 255;  // over red, in a row of the hatch
  for (int x = 220; x < 250; ++x) {
    const int blue = red.pixel(x, 150)[2] - red.pixel(x, 150)[0];
    most_blue = std::max(most_blue, blue);
    least_blue = std::min(least_blue, blue);
  }
  EXPECT_GT(most_blue, 20);
  EXPECT_GT(most_blue, least_blue + 20);
  EXPECT_GT(red.pixel(160, 150)[0], red.pixel(160, 150)[2] + 40);  // the tint covers a colour
  const Image plain = draw({.tint = Vec3f(1, 1, 1)});
  EXPECT_GT(plain.pixel(160, 150)[1], plain.pixel(160, 150)[0]);
}

TEST(PackedOverlay, KeepsFourBitsOfEachColourAndTheHatch) {
  EXPECT_EQ(packed_overlay(std::nullopt, false), 0);
  EXPECT_EQ(packed_overlay(std::nullopt, true), 2);
  EXPECT_EQ(packed_overlay(0xf0a05f, false), 0xfa51);
}

}  // namespace
}  // namespace burnish

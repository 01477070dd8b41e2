#include "client/surface/card_pages.h"

#include <gtest/gtest.h>

#include "client/scene/null_page_renderer.h"
#include "common/page_frames/shown_pages.h"
#include "tests/client/scene/page_splitter.h"
#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

constexpr int kSurfaceDepth = 6;

/// A sphere in pages, all on the card and in the frame.
class CardPagesTest : public testing::Test {
 protected:
  CardPagesTest()
      : split_(split_into_pages(make_test_sphere(Vec3d::Zero(), 1, 16), 200)),
        card_(split_.grid, kSurfaceDepth),
        marks_(tint_) {
    const auto slots = static_cast<uint32_t>(split_.pages.size());
    EXPECT_EQ(card_.open(renderer_, slots).value(), slots);
    for (uint32_t slot = 0; slot < slots; ++slot) {
      const Page& page = split_.pages[slot];
      EXPECT_TRUE(card_.put(slot, page, make_page_mesh(page, split_.grid)).is_ok());
      const auto triangles = static_cast<uint32_t>(page.triangles.size());
      drawn_.push_back({slot, 0, triangles, page.id});
    }
  }

  /// A frame that moves all vertices by so many cells.
  SurfaceFrame frame(const Vec3f& move) const {
    SurfaceFrame frame;
    for (const Page& page : split_.pages) {
      frame.pages.push_back(page.id);
      frame.moves.push_back(std::make_shared<const PageMove>(
          PageMove{std::vector<Vec3f>(page.positions.size(), move)}));
    }
    return frame;
  }

  /// Looks at the middle of the picture from +z.
  SurfaceHit hit(bool original) {
    const ImageSize size{64, 64};
    Camera camera{.azimuth_degrees = 0, .elevation_degrees = 0};
    camera.distance = 5;
    const Eigen::Vector2i pixel(32, 32);
    const Ray ray = pixel_ray(camera, size, pixel.cast<double>() + Eigen::Vector2d(0.5, 0.5));
    return card_.hit(ray, original).value();
  }

  SplitMesh split_;
  NullPageRenderer renderer_;
  CardPages card_;
  StrokeTint tint_{split_.grid, kSurfaceDepth};
  PageMarks marks_;
  std::vector<DrawnRange> drawn_;
};

TEST_F(CardPagesTest, APagesTextureIsWithItUntilItGoes) {
  const auto texture = std::make_shared<const PageTexture>();
  const PageId textured = split_.pages[1].id;
  const auto texture_of = [&](PageId page) { return page == textured ? texture : nullptr; };
  EXPECT_TRUE(card_.show_textures(texture_of).value());
  EXPECT_FALSE(card_.show_textures(texture_of).value());
  EXPECT_EQ(renderer_.texture(0), nullptr);
  EXPECT_EQ(renderer_.texture(1), texture.get());
  EXPECT_TRUE(card_.put(1, split_.pages[1], make_page_mesh(split_.pages[1], split_.grid)).is_ok());
  EXPECT_TRUE(card_.show_textures(texture_of).value()) << "a page that comes again has it again";
  EXPECT_TRUE(card_.show_textures([](PageId) { return nullptr; }).value());
  EXPECT_EQ(renderer_.texture(1), nullptr);
}

TEST_F(CardPagesTest, AFrameMovesTheDrawnPagesOnce) {
  const SurfaceFrame moved = frame(Vec3f(0, 0, 4));
  EXPECT_TRUE(card_.show(drawn_, moved, marks_).value());
  EXPECT_FALSE(card_.show(drawn_, moved, marks_).value());
}

TEST_F(CardPagesTest, ColoursChangeByTheFrameAndNoChangeKeepsThem) {
  const Rgba8 grey{100, 100, 100, 7};
  Page page = split_.pages[0];
  page.colours.assign(page.positions.size(), grey);
  ASSERT_TRUE(card_.put(0, page, make_page_mesh(page, split_.grid)).is_ok());
  SurfaceFrame coloured = frame(Vec3f::Zero());
  coloured.pages.push_back(page.id | kColourPages);
  const auto change = [&](const Vec3f& linear) {
    std::vector<Vec3f> of_all(page.positions.size(), kCellsPerColour * linear);
    return std::make_shared<const PageMove>(PageMove{std::move(of_all)});
  };
  coloured.moves.push_back(change(Vec3f(1, 0, -1)));
  EXPECT_TRUE(card_.show(drawn_, coloured, marks_).value());
  EXPECT_EQ(renderer_.colours(0).front(), (Rgba8{255, 100, 0, 7}));
  EXPECT_FALSE(card_.show(drawn_, coloured, marks_).value());
  coloured.moves.back() = change(Vec3f::Zero());
  EXPECT_TRUE(card_.show(drawn_, coloured, marks_).value());
  EXPECT_EQ(renderer_.colours(0).back(), grey);
  EXPECT_TRUE(renderer_.texels(0).back().is_none());
  coloured.pages.push_back(page.id | kGainPages);
  coloured.moves.push_back(change(Vec3f(0.5F, 0, 0)));
  EXPECT_TRUE(card_.show(drawn_, coloured, marks_).value());
  EXPECT_EQ(renderer_.colours(0).back(), grey);
  const TexelChange texel = renderer_.texels(0).back();
  EXPECT_EQ(texel.gain, 1.5F);
  const auto own = std::pow(100 / 255.F, 2.2F);
  EXPECT_NEAR(texel.gain * own + texel.light.x(), own, 1e-6) << "a texel like its vertex stays";
}

TEST_F(CardPagesTest, APointIsFoundOnTheDisplacedAndOnTheOriginalSurface) {
  const double cell = split_.grid.side / (1 << kSurfaceDepth);
  ASSERT_TRUE(card_.show(drawn_, frame(Vec3f(0, 0, 4)), marks_).is_ok());
  const SurfaceHit displaced = hit(false);
  EXPECT_NEAR(displaced.displaced.z(), 1 + 4 * cell, 0.02);
  EXPECT_NEAR((displaced.displaced - displaced.original).norm(), 4 * cell, 1e-6);
  EXPECT_NEAR(hit(true).displaced.z(), 1, 0.02);
}

TEST_F(CardPagesTest, APointKnowsItsMoveAlongTheNormalAndItsMark) {
  const double cell = split_.grid.side / (1 << kSurfaceDepth);
  for (const Page& page : split_.pages)
    marks_.set_values(page.id, std::vector<int8_t>(page.positions.size(), 50));
  ASSERT_TRUE(card_.show(drawn_, frame(Vec3f(0, 0, -4)), marks_).is_ok());
  const SurfaceHit found = hit(false);
  EXPECT_GT(found.normal.z(), 0.98);  // outwards
  EXPECT_NEAR(found.moved(), -4 * cell, 0.02 * cell);
  EXPECT_NEAR(found.mark, 50, 1e-9);
}

TEST_F(CardPagesTest, ADabMarksThePagesThatItTouches) {
  const SurfaceFrame still = frame(Vec3f::Zero());
  card_.show(drawn_, still, marks_).value();
  tint_.add_dab({.radius = 0.2, .strength = 1, .beta = 0}, Vec3d(0, 0, 1));
  EXPECT_TRUE(card_.show(drawn_, still, marks_).value());
  EXPECT_FALSE(card_.show(drawn_, still, marks_).value());
  tint_.clear();
  EXPECT_TRUE(card_.show(drawn_, still, marks_).value());
}

TEST_F(CardPagesTest, ValuesOfAPageMarkItOnce) {
  const SurfaceFrame still = frame(Vec3f::Zero());
  card_.show(drawn_, still, marks_).value();
  marks_.set_values(1, std::vector<int8_t>(split_.pages[1].positions.size(), 100));
  EXPECT_TRUE(card_.show(drawn_, still, marks_).value());
  EXPECT_FALSE(card_.show(drawn_, still, marks_).value());
}

/// A card that has room for some pages alone.
class SmallCard : public NullPageRenderer {
 public:
  explicit SmallCard(uint32_t slots) : slots_(slots) {}
  Status reserve(uint32_t slots) override {
    if (slots > slots_) return resource_exhausted("no room");
    return NullPageRenderer::reserve(slots);
  }

 private:
  uint32_t slots_;
};

TEST(CardPagesRoom, ASmallCardTakesFewerPagesAndATinyOneNone) {
  CardPages card(PageGrid{}, kSurfaceDepth);
  SmallCard small(300);
  EXPECT_EQ(card.open(small, 1000).value(), 250u);
  SmallCard tiny(10);
  EXPECT_EQ(card.open(tiny, 1000).status().code(), StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace burnish

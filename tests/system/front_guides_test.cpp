// The scale bar and the axes over the page's picture.

#include <algorithm>
#include <fstream>

#include "client/scene/png_reader.h"
#include "common/base/limits.h"
#include "tests/system/front_service.h"

namespace burnish {
namespace {

class FrontGuides : public FrontService {
 protected:
  Viewport& viewport() { return front_.workspace().viewport; }

  Eigen::Vector2d place_of(UpAxis axis) {
    const AxesGizmo gizmo = viewport().axes().value();
    return std::ranges::find(gizmo.ends, axis, &AxisEnd::axis)->place;
  }

  void click(const Eigen::Vector2d& place) {
    point("press", place.x(), place.y());
    point("release", place.x(), place.y());
  }

  // Returns how many pixels of a downloaded picture are of a mark's ink.
  int ink_in(const std::string& name) {
    const auto file = server_.folder / name;
    std::ofstream(file, std::ios::binary) << downloads_.at(name);
    const Image image = read_png(file, kImageSidePixelsMax).value();
    int ink = 0;
    for (size_t i = 0; i < image.rgb.size(); i += 3) ink += image.rgb[i] == 230;
    return ink;
  }
};

TEST_F(FrontGuides, TheScaleBarTellsItsLengthInTheScansUnitAndFollowsTheCamera) {
  ASSERT_TRUE(open());
  EXPECT_EQ(guides_["bar"]["text"], "2");  // of a ball of radius 1
  const double before = guides_["bar"]["pixels"];
  line("unit mm");
  EXPECT_TRUE(until([this] { return guides_["bar"]["text"] == "2 mm"; }));
  viewport().camera.distance *= 1.1;
  EXPECT_TRUE(until([&] { return guides_["bar"]["pixels"] < before; }));
  viewport().camera.distance *= 10;
  EXPECT_TRUE(until([this] { return guides_["bar"]["text"] == "20 mm"; }));
}

TEST_F(FrontGuides, BothAreSwitchedOff) {
  ASSERT_TRUE(start());
  EXPECT_TRUE(guides_["bar"].is_null() && guides_["axes"].is_null());
  ASSERT_TRUE(open());
  EXPECT_EQ(guides_["axes"]["ends"].size(), 6u);
  line("panel commit off View/Scale bar");
  line("panel commit off View/Axes");
  EXPECT_TRUE(until([this] { return guides_["bar"].is_null() && guides_["axes"].is_null(); }));
}

TEST_F(FrontGuides, AClickOnAnEndIsTheStandardViewFromThereAndNoStroke) {
  ASSERT_TRUE(open());
  for (const UpAxis up : {UpAxis::kY, UpAxis::kMinusZ}) {
    line("up " + std::string(name_of(up)));
    line("view front");
    line("camera 25 20");
    line("view right");
    const Camera right = viewport().camera;
    line("camera 25 20");
    click(place_of(UpAxis::kX));
    EXPECT_EQ(viewport().camera, right) << name_of(up);
    line("view top");
    const Camera top = viewport().camera;
    line("camera 25 20");
    click(place_of(up));
    EXPECT_EQ(viewport().camera, top) << name_of(up);
  }
  ASSERT_TRUE(until([this] { return is_settled(); }));
  EXPECT_TRUE(document()["history"].empty());
}

TEST_F(FrontGuides, ADragOnTheAxesTurnsTheViewAndALittleMoveIsAClick) {
  ASSERT_TRUE(open());
  const Eigen::Vector2d place = place_of(UpAxis::kX);
  const Camera before = viewport().camera;
  point("press", place.x(), place.y());
  point("move", place.x() + 2, place.y());
  EXPECT_EQ(viewport().camera, before);
  point("move", place.x() + 40, place.y());
  point("release", place.x() + 40, place.y());
  EXPECT_LT(viewport().camera.azimuth_degrees, before.azimuth_degrees - 10);
  EXPECT_EQ(viewport().camera.elevation_degrees, before.elevation_degrees);
}

TEST_F(FrontGuides, AnEndUnderThePointerIsToldAndTheBrushHasNoRingThere) {
  ASSERT_TRUE(open());
  const Eigen::Vector2d place = place_of(UpAxis::kY);
  point("move", place.x(), place.y());
  const auto is_pointed = [this](bool wanted) {
    return until([&] {
      const Json& ends = guides_["axes"]["ends"];
      return wanted == std::ranges::any_of(ends, [](const Json& end) {
               return end["name"] == "y" && end["pointed"] == true;
             });
    });
  };
  EXPECT_TRUE(is_pointed(true));
  EXPECT_FALSE(viewport().hover().has_value());
  point("move", 200, 150);
  EXPECT_TRUE(is_pointed(false));
  EXPECT_TRUE(viewport().hover().has_value());
}

TEST_F(FrontGuides, ASavedPictureHasTheScaleBarThatIsShown) {
  ASSERT_TRUE(open());
  line("picture with.png");
  line("panel commit off View/Scale bar");
  line("picture without.png");
  EXPECT_GT(ink_in("with.png"), 100);
  EXPECT_EQ(ink_in("without.png"), 0);
}

TEST_F(FrontGuides, APictureOfAScriptHasAScaleBarIfTheScriptSaysSo) {
  ASSERT_TRUE(open());
  replay("screenshot without.png\nscale_bar on\nscreenshot with.png\n");
  ASSERT_TRUE(until([this] { return has_message("replayed"); }));
  EXPECT_EQ(ink_in("without.png"), 0);
  EXPECT_GT(ink_in("with.png"), 50);
  EXPECT_TRUE(viewport().options.scale_bar) << "the user's own stays";
}

TEST_F(FrontGuides, AScriptThatIsRecordedSavesThePictureAsItIsShown) {
  ASSERT_TRUE(open());
  line("record start");
  line("picture one.png");
  line("record stop");
  EXPECT_THAT(downloads_["work.script"], testing::HasSubstr("scale_bar on\nscreenshot one.png"));
}

}  // namespace
}  // namespace burnish

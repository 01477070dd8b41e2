// The equaliser, the palette and the wavelength in the window.

#include <algorithm>

#include <gmock/gmock.h>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/window_fixture.h"

namespace burnish {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class LayerWindow : public WindowTest {
 protected:
  // The panels are below the others, and begin closed.
  void open_panel(const std::string& name) {
    scroll_down();
    click_on(name);
    scroll_down();
  }

  // Of a point of the stroke that the tests draw.
  static int redness(const Image& image) {
    const uint8_t* rgb = image.pixel(kPictureX - 40, kPictureY);
    return int{rgb[0]} - int{rgb[1]};
  }

  void scroll_down() {
    constexpr int kColumnX = 110, kColumnY = 400, kWheelDown = 5;
    screen_->move(kColumnX, kColumnY);
    for (int i = 0; i < 60; ++i) {
      screen_->press(kWheelDown);
      screen_->release(kWheelDown);
    }
    settle();
  }
};

TEST_F(LayerWindow, AGainThatIsDraggedMovesTheSurface) {
  open_window();
  open_panel("Equaliser");
  click_on("Equaliser/Make bands");
  EXPECT_THAT(newest_of(1).summary, HasSubstr("bands"));
  scroll_down();
  const Image before = settle();
  const Box gain = places_->wait_for("Equaliser/Gain of band 2");
  const int y = gain.y + gain.height / 2;
  screen_->drag(gain.x + gain.width / 3, y, gain.x + gain.width - 4, y);
  EXPECT_THAT(newest_of(2).summary, HasSubstr(":3"));
  EXPECT_TRUE(until_it_differs(before, 0.1));
  save_screen("equaliser.png");
}

TEST_F(LayerWindow, EdgesAreKeptByAPresetAndItsStrengthIsDragged) {
  open_window();
  open_panel("Keep edges");
  click_on("Keep edges/Kept edges");
  click_on("Keep edges/Machined part");
  EXPECT_TRUE(eventually([&] { return newest_of(2).summary.starts_with("alpha"); }));
  scroll_down();
  const Image before = settle();
  save_screen("keep-edges.png");
  const Box strength = places_->wait_for("Keep edges/Strength of kept edges");
  const int y = strength.y + strength.height / 2;
  screen_->drag(strength.x + strength.width - 4, y, strength.x + 4, y);
  EXPECT_THAT(newest_of(3).summary, HasSubstr("edges"));
  EXPECT_TRUE(until_it_differs(before, 0.1));
}

TEST_F(LayerWindow, EdgesCannotBeChosenBesideBands) {
  open_window();
  open_panel("Equaliser");
  click_on("Equaliser/Make bands");
  EXPECT_THAT(newest_of(1).summary, HasSubstr("bands"));
  click_on("Equaliser");
  open_panel("Keep edges");
  click_on("Keep edges/Kept edges");
  settle();
  EXPECT_FALSE(places_->find("Keep edges/Machined part"));
  save_screen("edges-beside-bands.png");
}

TEST_F(LayerWindow, EdgesForThisScanAreKeptAsItsNoiseAsks) {
  open_window();
  open_panel("Keep edges");
  click_on("Keep edges/Kept edges");
  click_on("Keep edges/For this scan");
  ASSERT_TRUE(eventually([&] { return newest_of(2).summary.starts_with("alpha"); }));
  save_screen("for-this-scan.png");
  const auto is_of_noise = [](const HistoryEntry& entry) {
    return entry.summary.find("1 pass,") != std::string::npos;
  };
  EXPECT_TRUE(std::ranges::any_of(history(), is_of_noise));
}

TEST_F(LayerWindow, TheBrushPaintsItsBetaAgainAfterKeptEdges) {
  const Edit chosen{"chosen", SetEdges{{.edge_angle = 40}}};  // else the noise would choose one
  ASSERT_TRUE(connection_->apply("desk", {&chosen, 1}).is_ok());
  open_window();
  const auto paint = [&](const std::string& what) {
    click_on("Brush/Paints");
    click_on("Brush/" + what);
    screen_->drag(kPictureX - 40, kPictureY, kPictureX + 40, kPictureY);
  };
  paint("Strength of kept edges");
  EXPECT_THAT(newest_of(2).summary, HasSubstr("edges kept at strength 1"));
  paint("Gradient scale β");
  EXPECT_THAT(newest_of(3).summary, EndsWith("beta 0"));
  paint("Strength of kept edges");
  EXPECT_THAT(newest_of(4).summary, HasSubstr("edges kept at strength 1"));
  screen_->close_window();
  EXPECT_EQ(window_->wait(kPatience), 0) << window_->output();
  open_window();
  screen_->drag(kPictureX - 40, kPictureY, kPictureX + 40, kPictureY);
  EXPECT_THAT(newest_of(5).summary, EndsWith("beta 0"));
}

TEST_F(LayerWindow, ABrushPaintsACurveOfThePalette) {
  open_window();
  open_panel("Palette");
  click_on("Palette/Name");
  screen_->type("letters");
  click_on("Palette/Add");
  EXPECT_EQ(newest_of(1).summary, "palette of 1 curve");
  scroll_down();
  click_on("Palette/letters");
  save_screen("palette.png");
  click(kPictureX, kPictureY);
  EXPECT_THAT(newest_of(2).summary, HasSubstr("curve 1"));
}

TEST_F(LayerWindow, ACurvesColourLiesWhereItRulesWhileThePaletteIsOpen) {
  open_window();
  open_panel("Palette");
  click_on("Palette/Name");
  screen_->type("letters");
  click_on("Palette/Add");
  EXPECT_THAT(newest_of(1).summary, HasSubstr("palette"));
  scroll_down();
  const Image plain = settle();
  click_on("Palette/letters");
  screen_->drag(kPictureX - 80, kPictureY, kPictureX + 80, kPictureY);
  EXPECT_EQ(newest_of(2).kind, EditKind::kStroke);
  EXPECT_TRUE(eventually([&] { return redness(settle()) > redness(plain) + 30; }));
  save_screen("palette-over.png");
  click_on("Palette");
  EXPECT_TRUE(eventually([&] { return std::abs(redness(settle()) - redness(plain)) < 10; }));
}

TEST_F(LayerWindow, ColoursAreEvenedOutWhileTheirSliderIsDragged) {
  TriangleMesh spotted = generate_scan({.kind = "blob", .vertices = 20'000}).value();
  for (size_t v = 0; v < spotted.vertices.size(); ++v)
    spotted.colours.push_back(v % 7 == 0 ? Rgba8{250, 210, 120, 255} : Rgba8{120, 50, 20, 255});
  const auto scan = server_->folder / "spotted.ply";
  ASSERT_TRUE(write_mesh(spotted, scan).is_ok());
  ASSERT_EQ(server_->burnish({"import", scan.string()}).exit_code, 0);
  ASSERT_EQ(server_->burnish({"open", "spotted", "--session", "spots"}).exit_code, 0);
  start_window({"--session", "spots", "--scale", "1"});
  ASSERT_TRUE(shows_session()) << window_->output();
  open_panel("Colours");
  const Image before = settle();
  save_screen("colours-before.png");
  const Box scale = places_->wait_for("Colours/Gradient scale of colours");
  const int y = scale.y + scale.height / 2;
  screen_->drag(scale.x + scale.width / 2, y, scale.x + 4, y);
  EXPECT_TRUE(until_it_differs(before, 2));
  save_screen("colours.png");
  // The picture may differ before the button is up.
  EXPECT_TRUE(eventually([&] { return !connection_->history("spots")->empty(); }));
  EXPECT_THAT(connection_->history("spots").value().at(0).summary, HasSubstr("colours at beta 0"));
}

TEST_F(LayerWindow, TheProtectedRegionIsHatchedAndAStrokeInsideItIsRefused) {
  open_window();
  const Image plain = settle();
  scroll_down();
  screen_->move(kPictureX, kPictureY);
  click_on("Limits/Piece");
  EXPECT_THAT(newest_of(1).summary, HasSubstr("protect"));
  EXPECT_TRUE(until_it_differs(plain, 5));
  save_screen("protected.png");
  click(kPictureX, kPictureY);
  save_screen("refused.png");
  click_on("Limits/Clear");
  EXPECT_THAT(newest_of(2).summary, HasSubstr("protect"));  // the stroke is not there
  save_screen("refused-message.png");
  EXPECT_TRUE(until_it_is(plain, 1));
}

TEST_F(LayerWindow, AWavelengthThatIsTypedIsTheFidelity) {
  open_window();
  click_on("Filter/Wavelength as a number");
  screen_->type("0.5");
  screen_->key({"Return"});
  EXPECT_EQ(newest_of(1).kind, EditKind::kTransferCurve);
  save_screen("wavelength.png");
}

}  // namespace
}  // namespace burnish

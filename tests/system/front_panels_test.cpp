// Panels of client/panels, as the page shows and uses them.

#include <cstdio>
#include <string>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/front_service.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class FrontPanels : public FrontService {
 protected:
  /// Opens a session over a scan with colours.
  bool open_spotted() {
    TriangleMesh spotted = generate_scan({.kind = "blob", .vertices = 2000}).value();
    for (size_t v = 0; v < spotted.vertices.size(); ++v)
      spotted.colours.push_back(v % 7 == 0 ? Rgba8{250, 210, 120, 255} : Rgba8{120, 50, 20, 255});
    const auto file = server_.folder / "spotted.ply";
    if (!write_mesh(spotted, file).is_ok()) return false;
    if (!owner_.import_scan(file, "spotted", {5, 0}, {}).is_ok()) return false;
    const auto opened = owner_.open_session({"spotted", "spots", {5, 0}});
    if (!opened.is_ok() || !start()) return false;
    line("session join " + opened->session.id);
    return until([this] { return is_settled(); });
  }

  /// Returns a widget of the last snapshot; null if it is not there.
  Json widget(const std::string& panel, const std::string& name) {
    return find(document()["panels"][panel], name);
  }
  static Json find(const Json& widgets, const std::string& name) {
    for (const Json& one : widgets) {
      if (one.contains("widgets")) {
        if (const Json found = find(one["widgets"], name); !found.is_null()) return found;
      } else if (one["name"].get<std::string>().starts_with(name)) {
        return one;
      }
    }
    return {};
  }
  bool is_disabled(const std::string& panel, const std::string& name) {
    return widget(panel, name).contains("disabled");
  }

  bool has_edits(size_t count) {
    return until([&] { return is_settled() && document()["history"].size() == count; });
  }

  /// Returns what is answered to a line.
  std::string answer_to(const std::string& text) {
    answers_.clear();
    line(text);
    return answers_.empty() ? "" : answers_.back();
  }
};

TEST_F(FrontPanels, ASliderThatIsLetGoMakesOneEdit) {
  ASSERT_TRUE(open());
  for (const char* value : {"0.2", "0.4", "0.5"})
    line(std::string("panel preview ") + value + " Keep edges/Strength of kept edges");
  ASSERT_TRUE(until([this] { return widget("Keep edges", "Strength")["value"] == 0.5; }));
  EXPECT_TRUE(document()["history"].empty());
  line("panel commit 0.5 Keep edges/Strength of kept edges");
  ASSERT_TRUE(has_edits(1));
  EXPECT_EQ(front_.workspace().document()->edges().strength, 0.5);
  EXPECT_TRUE(answers_.empty());
}

TEST_F(FrontPanels, AValueOutsideItsSliderIsTheEndOfTheSlider) {
  ASSERT_TRUE(open());
  line("panel commit 121 Keep edges/Edge angle");
  EXPECT_EQ(front_.workspace().document()->edges().edge_angle, kEdgeAngleMax);
}

TEST_F(FrontPanels, ASizeOfNoiseIsACountOfPasses) {
  ASSERT_TRUE(open());
  const double edge = front_.workspace().document()->mean_edge();
  line("panel commit " + std::to_string(3 * edge) + " Keep edges/Noise size");
  EXPECT_EQ(front_.workspace().document()->edges().passes, 9);
}

TEST_F(FrontPanels, AChoiceSaysWhatIsChosen) {
  ASSERT_TRUE(open());
  EXPECT_EQ(widget("Keep edges", "Kept edges")["value"], "off");
  line("panel commit relief Keep edges/Kept edges");
  ASSERT_TRUE(until([this] { return widget("Keep edges", "Kept edges")["value"] == "relief"; }));
  EXPECT_EQ(widget("Keep edges", "Kept edges")["hint"], "For reliefs and inscriptions");
  ASSERT_TRUE(has_edits(2));  // with its fidelity
  line("panel commit 50 Keep edges/Edge angle");
  ASSERT_TRUE(until([this] { return widget("Keep edges", "Kept edges")["value"] == ""; }));
  EXPECT_THAT(widget("Keep edges", "Kept edges")["choices"].back().dump(), HasSubstr("Own values"));
  line("panel commit off Keep edges/Kept edges");
  EXPECT_TRUE(until([this] { return !document()["keepsEdges"]; }));
}

TEST_F(FrontPanels, BandsAndAVolumeThatStaysBarKeptEdges) {
  ASSERT_TRUE(open());
  line("bands 1:2");
  ASSERT_TRUE(until([this] { return !widget("Keep edges", "Bands have the scan").is_null(); }));
  EXPECT_TRUE(is_disabled("Keep edges", "Kept edges"));
  EXPECT_THAT(answer_to("panel commit relief Keep edges/Kept edges"), HasSubstr("no such widget"));
  line("bands");
  line("controls off 0 on");
  ASSERT_TRUE(until([this] { return !widget("Keep edges", "The volume stays").is_null(); }));
  EXPECT_TRUE(is_disabled("Keep edges", "Strength"));
  line("controls off 0 off");
  EXPECT_TRUE(until([this] { return !is_disabled("Keep edges", "Strength"); }));
}

TEST_F(FrontPanels, ColoursAreFilteredAndKept) {
  ASSERT_TRUE(open_spotted());
  EXPECT_TRUE(widget("Colours", "Show colours").is_null());  // they are shown at first
  line("colour clay");
  ASSERT_TRUE(until([this] { return !widget("Colours", "Show colours").is_null(); }));
  line("panel commit press Colours/Show colours");
  EXPECT_EQ(front_.workspace().document()->colour(), ColourBy::kScan);
  line("panel commit 0.5 Colours/Gradient scale of colours");
  line("panel commit 0.25 Colours/Longest detail");
  const ColourFilter& filter = front_.workspace().document()->colour_filter();
  EXPECT_EQ(filter.beta, 0.5);
  EXPECT_TRUE(until([this] { return widget("Colours", "Longest detail")["value"] == 0.25; }));
  line("panel commit press Colours/Keep colours");
  EXPECT_EQ(filter.beta, 1);
  line("panel commit 2.5 Colours/Texture gain");
  line("panel commit 0.75 Colours/Remove light");
  ASSERT_TRUE(has_edits(5));
  EXPECT_EQ(front_.workspace().document()->texture().gain, 2.5);
  EXPECT_EQ(front_.workspace().document()->texture().remove_light, 0.75);
}

TEST_F(FrontPanels, ABrushPaintsItsBetaAgainAfterKeptEdges) {
  ASSERT_TRUE(open());
  const Brush& brush = front_.workspace().document()->brush().brush;
  line("panel commit press Brush/Sharpen");
  EXPECT_EQ(brush.beta, 2);
  line("panel commit edges Brush/Paints");
  EXPECT_TRUE(brush.edges && brush.beta == 1);
  ASSERT_TRUE(until([this] { return widget("Brush", "Denoise here")["pressed"] == true; }));
  line("panel commit press Brush/Keep here");
  EXPECT_EQ(brush.beta, 0);
  line("panel commit 0.5 Brush/Painted strength");
  line("panel commit beta Brush/Paints");
  EXPECT_TRUE(!brush.edges && brush.beta == 2);
  EXPECT_TRUE(answers_.empty());
}

TEST_F(FrontPanels, ABrushForgetsABandThatIsGone) {
  ASSERT_TRUE(open());
  line("bands 1:2");
  ASSERT_TRUE(has_edits(1));
  line("panel commit band:1 Brush/Paints");
  ASSERT_TRUE(until([this] { return widget("Brush", "Paints")["value"] == "band:1"; }));
  line("undo");
  ASSERT_TRUE(until([this] { return widget("Brush", "Paints")["value"] == "beta"; }));
  EXPECT_EQ(front_.workspace().document()->brush().brush.band, 0);
}

TEST_F(FrontPanels, AMirrorIsAPlaneThroughTheMiddleAtFirst) {
  ASSERT_TRUE(open());
  const Document& document = *front_.workspace().document();
  line("panel commit y Brush/Mirror");
  ASSERT_TRUE(document.mirror);
  EXPECT_EQ(document.mirror->at, document.box().center().y());
  line("panel preview 0.25 Brush/Mirror plane");
  EXPECT_EQ(document.mirror->at, 0.25);
  line("panel commit off Brush/Mirror");
  EXPECT_FALSE(document.mirror);
}

TEST_F(FrontPanels, AnOpenScanSaysHowManyRimsStayAsSoonAsTheyDo) {
  const auto sheet = server_.folder / "sheet.ply";
  ASSERT_TRUE(write_mesh(make_sheet(20, 4, 0.1), sheet).is_ok());
  ASSERT_TRUE(owner_.import_scan(sheet, "sheet", {5, 0}, {}).is_ok());
  const auto opened = owner_.open_session({"sheet", "free", {5, 0}});
  ASSERT_TRUE(opened.is_ok()) << opened.status().to_string();
  const Edit let_go{"let-go", SetControls{{.pin_rims = false}}};
  ASSERT_TRUE(owner_.apply("free", {&let_go, 1}).is_ok());
  ASSERT_TRUE(start());
  line("session join " + opened->session.id);
  ASSERT_TRUE(until([this] { return is_settled(); }));
  EXPECT_TRUE(widget("Limits", "rims: ").is_null());
  EXPECT_TRUE(widget("Limits", "Walls: ").is_null()) << "a sheet has none";
  line("panel commit on Limits/Rims stay");
  EXPECT_TRUE(until([this] { return !widget("Limits", "rims: 1 of 1 stay").is_null(); }));
  line("panel commit off Limits/Rims stay");
  EXPECT_TRUE(until([this] { return widget("Limits", "rims: ").is_null(); }));
}

TEST_F(FrontPanels, AnOpenScanSaysHowMuchOfItIsOnThinWalls) {
  const auto sheets = server_.folder / "sheets.ply";
  ASSERT_TRUE(write_mesh(generate_scan({"sheets", 2000, 1}).value(), sheets).is_ok());
  ASSERT_TRUE(owner_.import_scan(sheets, "sheets", {5, 0}, {}).is_ok());
  const auto opened = owner_.open_session({"sheets", "thin", {5, 0}});
  ASSERT_TRUE(opened.is_ok()) << opened.status().to_string();
  ASSERT_TRUE(start());
  line("session join " + opened->session.id);
  ASSERT_TRUE(until([this] { return is_settled(); }));
  EXPECT_FALSE(widget("Limits", "Walls: 100 % of the surface is thinner than a cell").is_null());
}

TEST_F(FrontPanels, LimitsAreSetAndTheirCapIsOffAtTheRight) {
  ASSERT_TRUE(open());
  EXPECT_TRUE(is_disabled("Limits", "Rims stay"));  // a sphere has none
  line("panel commit on Limits/Volume stays");
  line("panel preview 0.3 Limits/Largest move");
  line("panel commit 0.2 Limits/Largest move");
  ASSERT_TRUE(has_edits(2));
  const Controls& controls = front_.workspace().document()->controls();
  EXPECT_EQ(controls.cap, 0.2);
  EXPECT_TRUE(controls.keep_volume);
  const double any = widget("Limits", "Largest move")["high"];
  char rounded[32];
  std::snprintf(rounded, sizeof(rounded), "%.9g", any * (1 - 4e-6));  // as by six digits
  line(std::string("panel commit ") + rounded + " Limits/Largest move");
  EXPECT_EQ(controls.cap, 0);
  line("panel commit 0.2 Limits/Largest move");
  line("panel commit 1000 Limits/Largest move");
  EXPECT_EQ(controls.cap, 0);
  EXPECT_THAT(answer_to("panel commit nan Limits/Largest move"), HasSubstr("'nan'"));
  EXPECT_THAT(answer_to("panel commit up Limits/Volume stays"), HasSubstr("'up'"));
}

TEST_F(FrontPanels, ABrushOfColoursThatTheScanLacksPaintsItsBeta) {
  ASSERT_TRUE(open());
  for (const char* word : {"colour", "texture"}) {
    line(std::string("brush 0.1 1 0 smooth ") + word);
    EXPECT_EQ(widget("Brush", "Paints")["value"], "beta") << word;
  }
}

TEST_F(FrontPanels, APieceIsProtectedOnceThePointerWasOnIt) {
  ASSERT_TRUE(open());
  EXPECT_TRUE(is_disabled("Limits", "Piece"));
  point("move", 200, 150);
  ASSERT_TRUE(until([this] { return !is_disabled("Limits", "Piece"); }));
  line("panel commit press Limits/Piece");
  ASSERT_TRUE(has_edits(1));
  line("panel commit press Limits/Grow");
  ASSERT_TRUE(has_edits(2));
}

TEST_F(FrontPanels, AWishForALassoIsTakenBackByTheSameButton) {
  ASSERT_TRUE(open());
  const auto& wish = front_.workspace().viewport.lasso_wish;
  line("panel commit on Limits/Through");
  line("panel commit press Limits/Release");
  ASSERT_TRUE(wish);
  EXPECT_TRUE(wish->through && wish->release);
  ASSERT_TRUE(until([this] { return widget("Limits", "Release")["pressed"] == true; }));
  line("panel commit off Limits/Through");
  EXPECT_FALSE(wish->through);
  line("panel commit press Limits/Release");
  EXPECT_FALSE(wish);
}

TEST_F(FrontPanels, TheViewIsSetAndBookmarksAreShown) {
  ASSERT_TRUE(open());
  Viewport& viewport = front_.workspace().viewport;
  for (const char* name : {"Flat", "Wireframe", "Split", "Original", "Left button turns the view"})
    line(std::string("panel commit on View/") + name);
  EXPECT_TRUE(viewport.options.flat && viewport.options.wireframe && viewport.options.split);
  EXPECT_TRUE(viewport.hold_original && viewport.navigate_mode);
  for (const char* name : {"Scale bar", "Axes"}) line(std::string("panel commit off View/") + name);
  EXPECT_FALSE(viewport.options.scale_bar || viewport.options.axes);
  line("panel preview 0.25 View/Place of the split");
  EXPECT_EQ(viewport.options.split_at, 0.25);
  line("panel commit displacement View/Colour");
  const double cell = document()["cellSize"];
  line("panel commit " + std::to_string(2 * cell) + " View/Blue below zero");
  line("panel commit " + std::to_string(0.5 * cell) + " View/Red above zero");
  EXPECT_NEAR(viewport.options.displacement.low, 2, 1e-3);
  EXPECT_NEAR(viewport.options.displacement.high, 0.5, 1e-3);
  line("panel commit press View/Automatic ends");
  EXPECT_EQ(viewport.options.displacement, ColourEnds());
  line("panel commit press Camera/Top");
  line("panel commit press View/Bookmark");
  const Camera top = viewport.camera;
  line("panel commit press Camera/Front");
  line("panel commit -x Camera/Up");
  line("panel commit on Camera/Orthographic");
  EXPECT_EQ(viewport.camera.up, UpAxis::kMinusX);
  EXPECT_TRUE(viewport.camera.orthographic);
  line("panel commit press View/Bookmark 1");
  EXPECT_EQ(viewport.camera, top);
  line("turn 15 -30");
  EXPECT_EQ(viewport.camera.azimuth_degrees, turned(top, 15, -30).azimuth_degrees);
  EXPECT_EQ(viewport.camera.elevation_degrees, turned(top, 15, -30).elevation_degrees);
  EXPECT_TRUE(answers_.empty());
}

TEST_F(FrontPanels, ALineThatNoWidgetUnderstandsIsAnswered) {
  ASSERT_TRUE(open());
  EXPECT_THAT(answer_to("panel commit 1 Keep edges"), HasSubstr("no panel of 'Keep edges'"));
  EXPECT_THAT(answer_to("panel commit 1 Sky/Blue"), HasSubstr("no panel of 'Sky/Blue'"));
  EXPECT_THAT(answer_to("panel commit 1 Keep edges/Blue"), HasSubstr("no such widget"));
  EXPECT_THAT(answer_to("panel commit x Keep edges/Crispness"), HasSubstr("'x'"));
  EXPECT_THAT(answer_to("panel commit blue Keep edges/Kept edges"), HasSubstr("'blue'"));
  EXPECT_THAT(answer_to("panel commit 1"), HasSubstr("needs 3"));
}

}  // namespace
}  // namespace burnish

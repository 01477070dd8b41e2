// Panels of client/panels, as the page shows and uses them.

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
    for (const Json& one : document()["panels"][panel])
      if (one["name"].get<std::string>().starts_with(name)) return one;
    return {};
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
  EXPECT_EQ(widget("Keep edges", "Kept edges")["disabled"], true);
  EXPECT_THAT(answer_to("panel commit relief Keep edges/Kept edges"), HasSubstr("no such widget"));
  line("bands");
  line("controls off 0 on");
  ASSERT_TRUE(until([this] { return !widget("Keep edges", "The volume stays").is_null(); }));
  EXPECT_EQ(widget("Keep edges", "Strength")["disabled"], true);
  line("controls off 0 off");
  EXPECT_TRUE(until([this] { return widget("Keep edges", "Strength")["disabled"] == false; }));
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

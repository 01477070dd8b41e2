// Small pictures of strengths to choose from, over a real server and with real pictures.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "client/model/workspace/session_pictures.h"
#include "client/raster/raster_page_renderer.h"
#include "client/tools/presets.h"
#include "common/base/text_lines.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/front_service.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class StrengthsOfThePage : public FrontService {
 protected:
  StrengthsOfThePage() : FrontService(std::make_unique<RasterPageRenderer>(1), "window.toml") {}

  /// Opens a session over a noisy tablet. `preset`: "NAME STRENGTH".
  void open_with(const std::string& preset) {
    const auto file = server_.folder / "noisy.ply";
    const auto tablet = generate_scan({"tablet", 4000, 1, 0.3, NoiseKind::kGauss});
    ASSERT_TRUE(write_mesh(tablet.value(), file).is_ok());
    ASSERT_TRUE(owner_.import_scan(file, "tablet", {6, 0}, {}).is_ok());
    const auto opened = owner_.open_session({"tablet", "desk", {6, 0}});
    ASSERT_TRUE(opened.is_ok() && start());
    line("session join " + opened->session.id);
    ASSERT_TRUE(rests());
    line("preset " + preset);
    ASSERT_TRUE(rests());
  }

  Document& shown() { return *front_.workspace().document(); }
  StrengthStrip& strip() { return front_.workspace().strip; }

  /// Ticks until the picture shows all edits.
  bool rests() {
    return until([this] {
      const Document* const document = front_.workspace().document();
      return document && document->is_settled() && document->is_picture_settled() && is_settled();
    });
  }

  bool has_all() {
    return until([this] {
      return strip().is_open() && std::ranges::all_of(strip().pictures(), [](const auto& picture) {
               return picture.number > 0;
             });
    });
  }

  /// Opens the strip, and ticks until the session shows another strength than its own.
  bool is_trying() {
    line("strengths open");
    return until([this] { return shown().is_trying(); });
  }

  /// Opens the strip, and ticks until the picture on the screen is of another strength.
  bool shows_another_than(const Image& before) {
    line("strengths open");
    return until([&] { return difference(before, drawn()) > 0.25; });
  }

  /// Has the picture of the session kept, and returns the file's bytes.
  std::string kept_picture() {
    Workspace& workspace = front_.workspace();
    workspace.keep_session_picture();
    const auto file =
        picture_path(workspace.picture_folder(), workspace.preferences.recent.front());
    return read_text_file(file).value();
  }

  /// Returns what a preset is on the session's scan.
  PresetFilter filter(const char* preset, double strength = 1) {
    return filter_of(*find_preset(preset), strength, shown().lengths());
  }

  bool has_closed() {
    return until([this] { return !strip().is_open() && !shown().is_trying(); });
  }

  /// Returns the picture that is on the screen, as small as the strip's.
  Image drawn() { return shrunk(renderer_->read_pixels().value(), kStrengthPictureSize); }

  /// Returns the mean difference, in steps of 255.
  static double difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.size, b.size);
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(int{a.rgb[i]} - int{b.rgb[i]});
    return sum / static_cast<double>(a.rgb.size());
  }

  std::array<Image, 3> pictures() {
    const auto& all = strip().pictures();
    return {all[0].image, all[1].image, all[2].image};
  }

  /// Chooses each picture, and compares it with what the session then shows.
  void expect_true_pictures() {
    line("strengths open");
    ASSERT_TRUE(has_all());
    ASSERT_TRUE(rests());
    const std::array<Image, 3> made = pictures();
    const double apart = std::min(difference(made[0], made[1]), difference(made[1], made[2]));
    EXPECT_GT(apart, 0.5) << "strengths can be told apart";
    for (size_t i = 0; i < made.size(); ++i) {
      const double strength = strip().pictures()[i].strength;
      line("strengths choose " + std::to_string(i));
      ASSERT_TRUE(rests());
      ASSERT_TRUE(strip().is_open()) << "the pictures stay";
      EXPECT_NEAR(shown().preset_in_force({})->strength, strength, 1e-5);
      EXPECT_LT(difference(made[i], drawn()), apart / 5) << "picture " << i;
    }
  }
};

TEST_F(StrengthsOfThePage, PicturesShowWhatTheirStrengthsOfBetaGive) {
  open_with("Sharpen all 1");
  expect_true_pictures();
}

TEST_F(StrengthsOfThePage, PicturesShowWhatTheirStrengthsOfBandsGive) {
  open_with("Bring out an inscription 0.5");
  expect_true_pictures();
}

// The move of the surface is no multiple of the strength there.
TEST_F(StrengthsOfThePage, PicturesAreTrueBesidePaintAndUnderACap) {
  open_with("Sharpen all 1");
  line("controls off " + std::to_string(0.5 * shown().cell_size()) + " off");
  line("brush " + std::to_string(0.1 * shown().diagonal()) + " 1 0");
  point("press", 180, 150);
  point("move", 230, 150);
  point("release", 230, 150);
  point("leave", 0, 0);
  ASSERT_TRUE(until([this] { return document()["history"].size() > 3; }));
  ASSERT_TRUE(rests());
  expect_true_pictures();
}

TEST_F(StrengthsOfThePage, ThePageHasThePicturesAndTheSessionKeepsItsValues) {
  open_with("Soften 1");
  const Image before = drawn();
  const uint64_t edits = shown().edits_known();
  line("strengths open");
  ASSERT_TRUE(has_all());
  ASSERT_TRUE(until([this] {
    const Json& said = snapshot_["strengths"];
    return said["trial"] == "" && std::ranges::all_of(said["pictures"], [](const Json& picture) {
             return picture["number"] != 0;
           });
  }));
  for (const Json& picture : snapshot_["strengths"]["pictures"])
    EXPECT_THAT(strengths_[picture["number"]], HasSubstr("data:image/png;base64,"));
  ASSERT_TRUE(rests());
  EXPECT_EQ(shown().edits_known(), edits);
  EXPECT_NEAR(shown().beta(), filter("Soften").beta, 1e-9);
  EXPECT_LT(difference(before, drawn()), 0.1);
}

TEST_F(StrengthsOfThePage, TheViewSaysWhatItTries) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  EXPECT_EQ(strip().trial_text(), "trying strength 0.33");
  EXPECT_FALSE(shown().is_settled());
  EXPECT_NEAR(shown().beta(), filter("Soften").beta, 1e-9) << "sliders stay";
}

// The server may take the preview and its end at once, or hear of neither.
TEST_F(StrengthsOfThePage, ATrialThatEndsAtOnceLeavesTheSessionAtRest) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  line("strengths close");
  ASSERT_TRUE(rests());
  line("strengths open");
  EXPECT_TRUE(has_all());
}

TEST_F(StrengthsOfThePage, ASavedPictureIsNeverOfATrial) {
  open_with("Sharpen all 1");
  const Image before = drawn();
  ASSERT_TRUE(shows_another_than(before));
  meanwhile_ = [this] { front_.tick(std::chrono::steady_clock::now()); };
  line("picture one.png");
  EXPECT_FALSE(strip().is_open());
  EXPECT_FALSE(shown().is_picture_settled());
  EXPECT_TRUE(downloads_.empty());
  ASSERT_TRUE(until([this] { return downloads_.contains("one.png"); }));
  EXPECT_LT(difference(before, drawn()), 0.1);
}

TEST_F(StrengthsOfThePage, ThePictureThatIsKeptOfTheSessionIsNeverOfATrial) {
  open_with("Sharpen all 1");
  const std::string before = kept_picture();
  ASSERT_TRUE(shows_another_than(drawn()));
  EXPECT_EQ(kept_picture(), before) << "while it is tried";
  hear({{"kind", "visible"}, {"is", false}});
  EXPECT_FALSE(shown().is_trying());
  EXPECT_EQ(kept_picture(), before) << "right after its end";
}

TEST_F(StrengthsOfThePage, ARefusedEditTakesThePicturesAway) {
  open_with("Soften 1");
  line("strengths open");
  ASSERT_TRUE(has_all());
  shown().commit(SetGradientScale{-1});
  EXPECT_TRUE(has_closed());
  EXPECT_EQ(shown().refusals(), 1u);
}

TEST_F(StrengthsOfThePage, APresetOfBetaAndBandsHasNone) {
  ::setenv("XDG_CONFIG_HOME", (server_.folder / "config").c_str(), 1);
  open_with("Bring out an inscription 1");
  EXPECT_EQ(snapshot_["preset"]["hasTrial"], true);
  line("beta 0.5");
  line("preset_keep both");
  EXPECT_TRUE(until([this] { return snapshot_["preset"]["name"] == "both"; }));
  EXPECT_EQ(snapshot_["preset"]["hasTrial"], false);
  line("strengths open");
  EXPECT_FALSE(strip().is_open());
  ::unsetenv("XDG_CONFIG_HOME");
}

TEST_F(StrengthsOfThePage, AnEditOfTheUserEndsTheTrialAtOnce) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  line("beta 0.7");
  EXPECT_FALSE(shown().is_trying());
  ASSERT_TRUE(has_closed());
  ASSERT_TRUE(rests());
  EXPECT_EQ(owner_.state("desk")->settings.beta, 0.7);
}

TEST_F(StrengthsOfThePage, AStrokeOfTheUserEndsTheTrialAtOnce) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  const size_t entries = document()["history"].size();
  point("press", 200, 150);
  ASSERT_TRUE(until([this] { return shown().brush().is_drawing(); }));
  EXPECT_FALSE(shown().is_trying());
  point("release", 200, 150);
  ASSERT_TRUE(until([&] { return document()["history"].size() == entries + 1; }));
  EXPECT_TRUE(has_closed());
}

TEST_F(StrengthsOfThePage, AnotherUsersEditEndsTheTrial) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  const Edit edit{"theirs", SetGradientScale{0.4}};
  ASSERT_TRUE(owner_.apply("desk", {&edit, 1}).is_ok());
  ASSERT_TRUE(has_closed());
  ASSERT_TRUE(rests());
  EXPECT_EQ(shown().beta(), 0.4);
}

TEST_F(StrengthsOfThePage, AnotherUsersEditTakesThePicturesAway) {
  open_with("Soften 1");
  line("strengths open");
  ASSERT_TRUE(has_all());
  const Edit edit{"theirs", SetGradientScale{0.4}};
  ASSERT_TRUE(owner_.apply("desk", {&edit, 1}).is_ok());
  EXPECT_TRUE(has_closed());
}

TEST_F(StrengthsOfThePage, ALookElsewhereEndsTheTrial) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  line("view top");
  EXPECT_TRUE(has_closed());
  EXPECT_TRUE(rests());
}

TEST_F(StrengthsOfThePage, AHiddenPageAndAFoldedPanelEndTheTrial) {
  open_with("Soften 1");
  for (const Json& end : {Json{{"kind", "visible"}, {"is", false}},
                          Json{{"kind", "command"}, {"line", "strengths close"}}}) {
    hear({{"kind", "visible"}, {"is", true}});
    ASSERT_TRUE(is_trying());
    hear(end);
    EXPECT_FALSE(shown().is_trying());
    EXPECT_FALSE(strip().is_open());
  }
}

TEST_F(StrengthsOfThePage, AClosedSessionTakesThePicturesAlong) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  line("close");
  EXPECT_FALSE(strip().is_open());
  line("strengths close");
  EXPECT_TRUE(answers_.empty()) << answers_.front();
  line("strengths open");
  EXPECT_THAT(answers_.back(), HasSubstr("no session is open"));
}

TEST_F(StrengthsOfThePage, AChoiceBeforeAllPicturesAreThereCounts) {
  open_with("Soften 1");
  ASSERT_TRUE(is_trying());
  line("strengths choose 0");
  ASSERT_TRUE(has_closed());
  ASSERT_TRUE(rests());
  EXPECT_NEAR(owner_.state("desk")->settings.beta, filter("Soften", 1.0 / 3).beta, 1e-9);
}

TEST_F(StrengthsOfThePage, APresetThatAnotherUserAppliedStaysInForceAtTheChosenStrength) {
  open_with("Soften 1");
  const PresetFilter gentle = filter("Smooth gently");
  const Edit edits[] = {{"one", SetTransferCurve{gentle.curve}},
                        {"two", SetGradientScale{gentle.beta}}};
  ASSERT_TRUE(owner_.apply("desk", edits).is_ok());
  ASSERT_TRUE(until([this] { return snapshot_["preset"]["name"] == "Smooth gently"; }));
  line("strengths open");
  ASSERT_TRUE(has_all());
  line("strengths choose 1");
  ASSERT_TRUE(until([this] { return snapshot_["preset"]["word"] == "most"; }));
  EXPECT_EQ(snapshot_["preset"]["name"], "Smooth gently");
}

TEST_F(StrengthsOfThePage, AViewerHasNone) {
  open_with("Soften 1");
  const std::string id = shown().session().id;
  line("close");
  ASSERT_TRUE(owner_.set_role("desk", "mia", SessionRole::kViewer).is_ok());
  line("session join " + id);
  ASSERT_TRUE(rests());
  ASSERT_TRUE(until([this] { return shown().is_viewer(); }));
  line("strengths open");
  ASSERT_FALSE(answers_.empty());
  EXPECT_THAT(answers_.back(), HasSubstr("viewer"));
}

TEST_F(StrengthsOfThePage, WrongLinesAreRefused) {
  open_with("Soften 1");
  for (const auto& [wrong, reason] : {std::pair("strengths", "1"),
                                      {"strengths choose 1", "no pictures"},
                                      {"strengths look", "look"}}) {
    line(wrong);
    ASSERT_FALSE(answers_.empty()) << wrong;
    EXPECT_THAT(answers_.back(), HasSubstr(reason));
  }
  line("strengths open");
  line("strengths choose 3");
  EXPECT_THAT(answers_.back(), HasSubstr("picture 3 is outside 0 to 2"));
  line("curve 0:33");
  ASSERT_TRUE(rests());
  line("strengths open");
  EXPECT_THAT(answers_.back(), HasSubstr("no preset is in force"));
}

}  // namespace
}  // namespace burnish

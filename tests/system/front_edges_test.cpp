#include "client/model/documents/figures.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/front_service.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class KeptEdgesOfThePage : public FrontService {
 protected:
  /// Opens a session over a noisy machined part.
  bool open_part() {
    const auto file = server_.folder / "noisy.ply";
    const auto part = generate_scan({"part", 4000, 1, 0.2, NoiseKind::kGauss});
    if (!write_mesh(part.value(), file).is_ok()) return false;
    if (!owner_.import_scan(file, "part", {5, 0}, {}).is_ok()) return false;
    const auto opened = owner_.open_session({"part", "clean", {5, 0}});
    if (!opened.is_ok() || !start()) return false;
    line("session join " + opened->session.id);
    return until([this] { return is_settled(); });
  }

  std::string noise() { return noise_text(*front_.workspace().document()); }
  const EdgeFilter& edges() { return front_.workspace().document()->edges(); }
  std::string kept_edges() {
    const EdgePreset* const preset = preset_of(edges());
    return preset ? std::string(preset->name) : "";
  }

  /// Has the server lose the files that were imported.
  void lose_originals() {
    using Files = std::filesystem::recursive_directory_iterator;
    std::vector<std::filesystem::path> originals;
    for (const auto& entry : Files(server_.folder.path()))
      if (entry.path().stem() == "original") originals.push_back(entry.path());
    ASSERT_FALSE(originals.empty());
    for (const auto& path : originals) std::filesystem::remove(path);
  }
};

TEST_F(KeptEdgesOfThePage, EdgesForThisScanAreOneStepAndTheNoiseIsSaid) {
  ASSERT_TRUE(open_part());
  EXPECT_EQ(noise(), "");
  line("unit mm");
  line("keep_edges auto");
  EXPECT_EQ(noise(), "measuring the noise…");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 2; }));
  EXPECT_THAT(noise(), HasSubstr("noise about 0.0"));
  ASSERT_TRUE(until([this] { return noise().ends_with(" mm"); }));
  EXPECT_EQ(kept_edges(), "machined");
  EXPECT_NE(document()["fidelity"], 50);
  line("undo");
  ASSERT_TRUE(until([this] { return is_settled() && !edges().is_on(); }));
  EXPECT_EQ(document()["fidelity"], 50);
  line("keep_edges auto");  // the answer is known
  EXPECT_TRUE(until([this] { return is_settled() && document()["history"].size() == 4; }));
}

TEST_F(KeptEdgesOfThePage, AScanWithoutNoiseSaysSoAndChangesNothing) {
  ASSERT_TRUE(open());
  line("keep_edges auto");
  ASSERT_TRUE(until([this] { return has_message("too little to take away"); }));
  EXPECT_THAT(noise(), HasSubstr("too little to take away"));
  line("beta 0.5");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  EXPECT_FALSE(edges().is_on());
}

TEST_F(KeptEdgesOfThePage, APresetOfEdgesThatIsRefusedChangesNothing) {
  ASSERT_TRUE(open_part());
  line("bands 1:2");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  line("keep_edges relief");
  ASSERT_TRUE(until([this] { return has_message("refused: bands cannot stand beside"); }));
  EXPECT_TRUE(until([this] { return is_settled() && !edges().is_on(); }));
  EXPECT_EQ(document()["fidelity"], 50);
  EXPECT_EQ(owner_.history("clean")->size(), 1u);
}

TEST_F(KeptEdgesOfThePage, TheBrushKeepsEdgesAsTheNoiseAsksUntilSomebodyChooses) {
  ASSERT_TRUE(open_part());
  const auto drag = [this] {
    const auto is_drawing = [this] {
      front_.tick(std::chrono::steady_clock::now());
      return front_.workspace().document()->brush().is_drawing();
    };
    for (double x = 100; x < 300; x += 10) {  // the part has a bore
      point("press", x, 150);
      if (is_drawing()) return point("release", x, 150);
      point("release", x, 150);
    }
    FAIL() << "the pointer meets no surface";
  };
  const auto has = [this](size_t edits) {
    return until([&] { return is_settled() && document()["history"].size() == edits; });
  };
  ASSERT_TRUE(until([this] { return front_.workspace().document()->is_picture_settled(); }));
  line("brush 0.1 1 1 smooth edges");
  drag();  // the noise is not known yet
  ASSERT_TRUE(has(2));
  EXPECT_FALSE(edges().is_on());
  EXPECT_EQ(kept_edges(), "machined");
  line("undo");
  line("undo");
  ASSERT_TRUE(until([this] { return is_settled() && kept_edges() != "machined"; }));
  drag();
  ASSERT_TRUE(until([this] { return is_settled() && kept_edges() == "machined"; }));
  line("undo");
  ASSERT_TRUE(until([this] { return is_settled() && kept_edges() != "machined"; }))
      << "the filter and its stroke are one step";
  line("edges bilateral 0 50 8 0.5");
  drag();
  ASSERT_TRUE(has(6));
  EXPECT_EQ(edges().edge_angle, 50);
}

TEST_F(KeptEdgesOfThePage, EdgesThatAreChosenWhileTheNoiseIsMeasuredStay) {
  ASSERT_TRUE(open_part());
  line("keep_edges auto");
  line("keep_edges relief");
  ASSERT_TRUE(until([this] { return noise().starts_with("noise about") && is_settled(); }));
  line("beta 0.5");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 3; }));
  EXPECT_EQ(kept_edges(), "relief");
}

TEST_F(KeptEdgesOfThePage, ADragGoesOnWhileTheNoiseBecomesKnown) {
  ASSERT_TRUE(open_part());
  line("preview beta 0.3");
  line("keep_edges auto");
  ASSERT_TRUE(until([this] { return noise().starts_with("noise about"); }));
  EXPECT_EQ(document()["history"].size(), 0u);
  line("preview beta 0.4");
  line("beta 0.4");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 3; }));
  EXPECT_EQ(kept_edges(), "machined");
  EXPECT_EQ(document()["beta"], 0.4);
}

TEST_F(KeptEdgesOfThePage, ANoiseThatCannotBeMeasuredIsAMessageAndThePanelGoesOn) {
  ASSERT_TRUE(open_part());
  lose_originals();
  line("keep_edges auto");
  ASSERT_TRUE(until([this] { return has_message("noise: server"); }));
  EXPECT_EQ(noise(), "");
  line("keep_edges machined");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 2; }));
  EXPECT_EQ(kept_edges(), "machined");
}

TEST_F(KeptEdgesOfThePage, AScriptWaitsForTheNoiseBeforeItsNextLine) {
  ASSERT_TRUE(open_part());
  replay("join clean\nkeep_edges auto\nbeta 0.5\n");
  ASSERT_TRUE(until([this] { return has_message("replayed one.script") && is_settled(); }));
  ASSERT_TRUE(until([this] { return document()["history"].size() == 3; }));
  EXPECT_THAT(document()["history"][0].dump(), HasSubstr("Gradient scale 0.5"));
}

TEST_F(KeptEdgesOfThePage, AScriptEndsAtANoiseThatCannotBeMeasured) {
  ASSERT_TRUE(open_part());
  lose_originals();
  replay("join clean\nkeep_edges auto\nbeta 0.5\n");
  EXPECT_TRUE(until([this] { return has_message("one.script:2: keep_edges"); }));
}

TEST_F(KeptEdgesOfThePage, TheCommandKeepsEdgesByTheNoiseThatItSays) {
  ASSERT_TRUE(open_part());
  const CommandOutcome kept = server_.burnish({"edit", "clean", "--keep-edges", "auto"});
  EXPECT_EQ(kept.exit_code, 0) << kept.output;
  EXPECT_THAT(kept.output, HasSubstr("machined part: edges kept at strength 1"));
  EXPECT_THAT(kept.output, HasSubstr("2 edits applied"));
  const CommandOutcome less =
      server_.burnish({"edit", "clean", "--keep-edges", "auto", "--edge-strength", "0.25"});
  EXPECT_THAT(less.output, HasSubstr("machined part: edges kept at strength 0.25"));
  const CommandOutcome none =
      server_.burnish({"edit", "clean", "--keep-edges", "auto", "--edge-strength", "0"});
  EXPECT_THAT(none.output, HasSubstr("machined part: edges not kept"));
  const CommandOutcome off = server_.burnish({"edit", "clean", "--keep-edges", "off"});
  EXPECT_THAT(off.output, HasSubstr("1 edit applied"));
  EXPECT_THAT(owner_.history("clean")->back().summary, HasSubstr("edges not kept"));
  const CommandOutcome nothing = server_.burnish({"edit", "work", "--keep-edges", "auto"});
  EXPECT_EQ(nothing.exit_code, 0) << nothing.output;
  EXPECT_THAT(nothing.output, HasSubstr("too little to take away"));
  EXPECT_THAT(nothing.output, HasSubstr("0 edits applied, 0 in all"));
}

}  // namespace
}  // namespace burnish

#include "client/web/core/front.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "client/model/figures.h"
#include "client/scene/null_page_renderer.h"
#include "common/generate/generate.h"
#include "common/mesh/mesh_io.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using Json = nlohmann::json;
using std::chrono::milliseconds;
using testing::HasSubstr;

/// A page without a browser: a Front over the native model, with a session over a sphere.
class FrontService : public testing::Test {
 protected:
  FrontService() {
    EXPECT_TRUE(owner_.import_scan(write_sphere(server_.folder, 4), "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(owner_.open_session({"ball", "work", {5, 0}}).is_ok());
  }

  static void SetUpTestSuite() { ::setenv("OMP_WAIT_POLICY", "passive", 0); }

  FrontHost host() {
    FrontHost host;
    host.say = [this](const std::string& json) { take(Json::parse(json)); };
    host.show = [] {};
    host.is_drawing = [this] { return is_drawing_; };
    host.give = [](const GivenFile&) {};
    host.read = [this](const GivenFile& file) -> Result<std::string> { return given_[file.name]; };
    host.download = [this](const std::string& name, std::string_view bytes) {
      downloads_[name] = std::string(bytes);
    };
    host.begin = [this](std::function<void()> work) { work_ = std::move(work); };
    host.wait = [this](milliseconds time) {
      if (meanwhile_) meanwhile_();
      std::this_thread::sleep_for(time);
    };
    return host;
  }

  void take(const Json& message) {
    if (message["kind"] == "snapshot") snapshot_ = message["snapshot"];
    if (message["kind"] == "answer") answers_.push_back(message["message"]);
    if (message["kind"] == "drawn") drawn_ = message["count"];
  }

  void hear(const Json& message) { front_.hear(message.dump()); }
  void line(const std::string& text) { hear({{"kind", "command"}, {"line", text}}); }
  void point(const std::string& what, double x, double y) {
    hear({{"kind", "pointer"},
          {"what", what},
          {"x", x},
          {"y", y},
          {"button", 0},
          {"modifiers", 0},
          {"pressure", 1},
          {"pen", false},
          {"delta", 0}});
  }

  /// Ticks until the snapshot is as wished.
  bool until(const std::function<bool()>& done) {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < deadline) {
      front_.tick(std::chrono::steady_clock::now());
      if (work_) std::exchange(work_, {})();
      if (!snapshot_.is_null() && done()) return true;
      std::this_thread::sleep_for(milliseconds(2));  // the server has the clock
    }
    return false;
  }

  bool start() {
    hear({{"kind", "start"},
          {"width", 400},
          {"height", 300},
          {"pixelRatio", 1},
          {"address", "http://" + server_.address},
          {"user", "mia"},
          {"token", ""}});
    return until([this] { return !snapshot_["library"]["sessions"].empty(); });
  }

  bool open() {
    if (!start()) return false;
    line("session join " + snapshot_["library"]["sessions"][0]["id"].get<std::string>());
    return until(
        [this] { return is_settled() && front_.workspace().document()->is_picture_settled(); });
  }

  bool is_settled() { return !snapshot_["document"].is_null() && document()["settled"] == true; }
  const Json& document() { return snapshot_["document"]; }

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

  std::string noise() { return document()["edges"]["noise"]; }
  std::string kept_edges() { return document()["edges"]["preset"]; }
  bool has_message(const std::string& part) {
    return snapshot_["messages"].dump().find(part) != std::string::npos;
  }

  void replay(const std::string& script) {
    given_["one.script"] = script;
    hear({{"kind", "replay"},
          {"file", {{"handle", 1}, {"name", "one.script"}, {"size", script.size()}}}});
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

  ServerProcess server_;
  Connection owner_ = Connection::open(server_.address, kPatience).value();
  NullPageRenderer renderer_;
  Json snapshot_;
  std::vector<std::string> answers_;
  int drawn_ = 0;
  bool is_drawing_ = false;
  std::map<std::string, std::string> given_;
  std::map<std::string, std::string> downloads_;
  std::function<void()> work_;
  std::function<void()> meanwhile_;  // what happens while a script waits
  Front front_{renderer_, Preferences(), WorkspaceOptions{}, host()};
};

TEST_F(FrontService, TheStartShowsTheServersScansAndSessions) {
  ASSERT_TRUE(start());
  const Json& library = snapshot_["library"];
  EXPECT_EQ(library["state"], "connected");
  EXPECT_EQ(library["server"], server_.address);
  EXPECT_EQ(library["scans"][0]["name"], "ball");
  EXPECT_EQ(library["sessions"][0]["name"], "work");
  EXPECT_EQ(library["sessions"][0]["scan"], library["scans"][0]["id"]);
  EXPECT_GT(snapshot_["presets"].size(), 3u);
  EXPECT_TRUE(document().is_null());
}

TEST_F(FrontService, AnOpenScanSaysHowManyRimsStayAsSoonAsTheyDo) {
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
  EXPECT_EQ(document()["rims"], "");
  EXPECT_EQ(document()["walls"], "") << "a sheet has none";
  line("controls on 0 off");
  EXPECT_TRUE(until([this] { return document()["rims"] == "rims: 1 of 1 stay"; }));
  line("controls off 0 off");
  EXPECT_TRUE(until([this] { return document()["rims"] == ""; }));
}

TEST_F(FrontService, ThePresetBoxSaysWhatTheSessionHas) {
  ASSERT_TRUE(open());
  const auto is_shown = [this](const std::string& name, double strength) {
    return until([this, name, strength] {
      const Json& shown = snapshot_["preset"];
      return is_settled() && !shown.is_null() && shown["name"] == name &&
             std::abs(shown["strength"].get<double>() - strength) < 1e-5;
    });
  };
  const auto is_empty = [this] {
    return until([this] { return is_settled() && snapshot_["preset"].is_null(); });
  };
  EXPECT_TRUE(is_empty());
  line("preset Bring out an inscription 1");
  EXPECT_TRUE(is_shown("Bring out an inscription", 1));
  line("undo");
  EXPECT_TRUE(is_empty());
  EXPECT_TRUE(document()["bands"].empty());
  line("redo");
  EXPECT_TRUE(is_shown("Bring out an inscription", 1));
  line("preview preset Bring out an inscription 0.5");
  EXPECT_TRUE(until([this] { return snapshot_["preset"]["word"] == "half"; }));
  line("preset Bring out an inscription 0.5");
  EXPECT_TRUE(is_shown("Bring out an inscription", 0.5));
  line("preset Sharpen gently");
  EXPECT_TRUE(is_shown("Sharpen gently", 1));
  EXPECT_TRUE(document()["bands"].empty());
  line("beta 1.5");
  EXPECT_TRUE(is_shown("Sharpen gently", 0.5));
  line("curve 0:33");
  EXPECT_TRUE(is_empty());
}

TEST_F(FrontService, AnOpenScanSaysHowMuchOfItIsOnThinWalls) {
  const auto sheets = server_.folder / "sheets.ply";
  ASSERT_TRUE(write_mesh(generate_scan({"sheets", 2000, 1}).value(), sheets).is_ok());
  ASSERT_TRUE(owner_.import_scan(sheets, "sheets", {5, 0}, {}).is_ok());
  const auto opened = owner_.open_session({"sheets", "thin", {5, 0}});
  ASSERT_TRUE(opened.is_ok()) << opened.status().to_string();
  ASSERT_TRUE(start());
  line("session join " + opened->session.id);
  ASSERT_TRUE(until([this] { return is_settled(); }));
  EXPECT_THAT(document()["walls"].get<std::string>(),
              testing::StartsWith("Walls: 100 % of the surface is thinner than a cell"));
}

TEST_F(FrontService, AChangeSoonAfterASnapshotIsToldInTime) {
  ASSERT_TRUE(start());
  const auto now = std::chrono::steady_clock::now() + milliseconds(100);
  front_.workspace().log.info("first");
  EXPECT_EQ(front_.tick(now), Front::Time::max());
  front_.workspace().log.info("second");
  EXPECT_EQ(front_.tick(now + milliseconds(10)), now + milliseconds(50));
  EXPECT_EQ(snapshot_["messages"].size(), 1u);
  EXPECT_EQ(front_.tick(now + milliseconds(50)), Front::Time::max());
  EXPECT_EQ(snapshot_["messages"].size(), 2u);
}

TEST_F(FrontService, AnOpenSessionIsShownWithAllThatPanelsHave) {
  ASSERT_TRUE(open());
  // The session is settled before the server tells who looks on, and before a snapshot tells it.
  ASSERT_TRUE(until([this] {
    return !document()["people"].empty() && document()["view"]["status"] == "full detail";
  }));
  EXPECT_EQ(document()["session"], "work");
  EXPECT_EQ(document()["link"], "live");
  EXPECT_EQ(document()["depth"], 5);
  EXPECT_TRUE(document()["closed"]);
  EXPECT_EQ(document()["curve"]["line"].size(), 97u);
  EXPECT_EQ(document()["brush"]["paints"], "beta");
  EXPECT_EQ(document()["people"][0]["user"], "mia");
  EXPECT_EQ(document()["view"]["status"], "full detail");
  EXPECT_TRUE(document()["scale"].is_null());
  EXPECT_NEAR(document()["box"]["high"][0], 1, 0.01);
  EXPECT_GT(drawn_, 0);
}

TEST_F(FrontService, NoPictureBeginsWhileTheCardDrawsTheLast) {
  ASSERT_TRUE(open());
  is_drawing_ = true;
  hear({{"kind", "resize"}, {"width", 300}, {"height", 200}});
  const auto now = std::chrono::steady_clock::now();
  front_.tick(now);
  const int drawn = drawn_;
  hear({{"kind", "resize"}, {"width", 320}, {"height", 200}});
  EXPECT_LE(front_.tick(now + milliseconds(20)), now + milliseconds(50));
  EXPECT_EQ(drawn_, drawn);
  is_drawing_ = false;
  front_.tick(now + milliseconds(40));
  EXPECT_EQ(drawn_, drawn + 1);
}

TEST_F(FrontService, ALineOfTheScriptLanguageEditsTheSession) {
  ASSERT_TRUE(open());
  line("preview beta 0.5");
  ASSERT_TRUE(until([this] { return document()["beta"] == 0.5; }));
  line("beta 0");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  EXPECT_EQ(owner_.state("work")->settings.beta, 0);
  line("undo");
  ASSERT_TRUE(
      until([this] { return is_settled() && document()["history"][0]["enabled"] == false; }));
  EXPECT_EQ(document()["beta"], 1);
  EXPECT_TRUE(answers_.empty());
}

TEST_F(FrontService, AStrokeOfThePointerIsAnEdit) {
  ASSERT_TRUE(open());
  line("brush 0.3 0.8 0");
  point("press", 200, 150);
  point("move", 220, 150);
  point("release", 220, 150);
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  EXPECT_THAT(document()["history"][0]["summary"].get<std::string>(), HasSubstr("stroke"));
  EXPECT_TRUE(document()["hasPiece"]);
}

TEST_F(FrontService, ThePlotsPointsAreDraggedAndCommitted) {
  ASSERT_TRUE(open());
  line("plot grab 0.2 0.5 0.01 0.01");
  line("plot drag 0.25 0.9");
  ASSERT_TRUE(until([this] { return document()["curve"]["dragged"] == 0; }));
  line("plot drop");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  EXPECT_EQ(document()["curve"]["points"].size(), 2u);
  EXPECT_EQ(owner_.state("work")->settings.curve.to_string(), document()["curve"]["text"]);
}

TEST_F(FrontService, ARefusedLineIsAnsweredWithTheCoresWords) {
  ASSERT_TRUE(open());
  for (const auto& [text, words] :
       std::map<std::string, std::string>{{"beta 11", "11"},
                                          {"nonsense", "unknown command 'nonsense'"},
                                          {"scan open zz", "no scan 'zz'"},
                                          {"tool saw", "'saw' is not paint, look or measure"},
                                          {"preview zoom 2", "'zoom' has no preview"},
                                          {"plot take 7", "point 7"},
                                          {"bookmark show 3", "bookmark 3"},
                                          {"preview", "needs 1"},
                                          {"", "one line"}}) {
    answers_.clear();
    line(text);
    ASSERT_EQ(answers_.size(), 1u) << text;
    EXPECT_THAT(answers_[0], HasSubstr(words)) << text;
  }
}

TEST_F(FrontService, HostileMessagesAreAnsweredOrIgnored) {
  ASSERT_TRUE(open());
  for (const char* json :
       {"", "{", "[]", "12", "{\"kind\":7}", "{\"kind\":\"pointer\",\"x\":\"a\"}",
        "{\"kind\":\"import\",\"file\":3}", "{\"kind\":\"resize\",\"width\":-1}",
        "{\"kind\":\"resize\",\"width\":1e300,\"height\":1e300}"})
    front_.hear(json);
  EXPECT_TRUE(until([this] { return !answers_.empty(); }));
  hear({{"kind", "resize"}, {"width", 400}, {"height", 300}});
  line("beta 0");
  EXPECT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
}

TEST_F(FrontService, EveryFrontCommandOfThePageIsKnown) {
  ASSERT_TRUE(open());
  const std::string scan = snapshot_["library"]["scans"][0]["id"];
  for (const char* text : {"preview fidelity 30",
                           "fidelity 50",
                           "preview bands 0.5:1.2",
                           "preview edges edges 0.5 35 10 1",
                           "edges bilateral 1 35 2 0.5",
                           "keep_edges relief",
                           "keep_edges auto",
                           "edges off",
                           "bands first",
                           "bands",
                           "preview palette 50 d9534f soft ; 0:20,5:80 4a7fd0 hard",
                           "palette",
                           "preview controls on 0.1 off",
                           "controls off 0 on",
                           "library refresh",
                           "activity cancel 9",
                           "role ole editor",
                           "message dismiss 0",
                           "tool measure",
                           "tool look",
                           "tool paint",
                           "lasso protect through",
                           "lasso off",
                           "ruler clear",
                           "pen off",
                           "unit mm",
                           "split_at 0.3",
                           "displacement_range 2",
                           "lamp 0.2 0.4",
                           "light_default",
                           "bookmark add",
                           "bookmark show 1",
                           "focus",
                           "cancel",
                           "figures off",
                           "over protection on",
                           "over curves off",
                           "frame",
                           "view top",
                           "colour displacement",
                           "wireframe on",
                           "mirror x",
                           "checkpoint here",
                           "light raking",
                           "record start",
                           "record stop"}) {
    line(text);
    EXPECT_TRUE(answers_.empty()) << text << ": " << answers_.back();
    answers_.clear();
  }
  EXPECT_EQ(downloads_.count("work.script"), 1u);
}

TEST_F(FrontService, EdgesForThisScanAreOneStepAndTheNoiseIsSaid) {
  ASSERT_TRUE(open_part());
  EXPECT_EQ(noise(), "");
  line("unit mm");
  line("keep_edges auto");
  EXPECT_EQ(noise_text(*front_.workspace().document()), "measuring the noise…");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 2; }));
  EXPECT_THAT(noise(), HasSubstr("noise about 0.0"));
  ASSERT_TRUE(until([this] { return noise().ends_with(" mm"); }));
  EXPECT_EQ(kept_edges(), "machined");
  EXPECT_NE(document()["fidelity"], 50);
  line("undo");
  ASSERT_TRUE(until([this] { return is_settled() && document()["edges"]["strength"] == 0; }));
  EXPECT_EQ(document()["fidelity"], 50);
  line("keep_edges auto");  // the answer is known
  EXPECT_TRUE(until([this] { return is_settled() && document()["history"].size() == 4; }));
}

TEST_F(FrontService, AScanWithoutNoiseSaysSoAndChangesNothing) {
  ASSERT_TRUE(open());
  line("keep_edges auto");
  ASSERT_TRUE(until([this] { return has_message("too little to take away"); }));
  EXPECT_THAT(noise(), HasSubstr("too little to take away"));
  line("beta 0.5");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  EXPECT_EQ(document()["edges"]["strength"], 0);
}

TEST_F(FrontService, APresetOfEdgesThatIsRefusedChangesNothing) {
  ASSERT_TRUE(open_part());
  line("bands 1:2");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  line("keep_edges relief");
  ASSERT_TRUE(until([this] { return has_message("refused: bands cannot stand beside"); }));
  EXPECT_TRUE(until([this] { return is_settled() && document()["edges"]["strength"] == 0; }));
  EXPECT_EQ(document()["fidelity"], 50);
  EXPECT_EQ(owner_.history("clean")->size(), 1u);
}

TEST_F(FrontService, TheBrushKeepsEdgesAsTheNoiseAsksUntilSomebodyChooses) {
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
  EXPECT_EQ(document()["edges"]["strength"], 0);
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
  EXPECT_EQ(document()["edges"]["angle"], 50);
}

TEST_F(FrontService, EdgesThatAreChosenWhileTheNoiseIsMeasuredStay) {
  ASSERT_TRUE(open_part());
  line("keep_edges auto");
  line("keep_edges relief");
  ASSERT_TRUE(until([this] { return noise().starts_with("noise about") && is_settled(); }));
  line("beta 0.5");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 3; }));
  EXPECT_EQ(kept_edges(), "relief");
}

TEST_F(FrontService, ADragGoesOnWhileTheNoiseBecomesKnown) {
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

TEST_F(FrontService, ANoiseThatCannotBeMeasuredIsAMessageAndThePanelGoesOn) {
  ASSERT_TRUE(open_part());
  lose_originals();
  line("keep_edges auto");
  ASSERT_TRUE(until([this] { return has_message("noise: server"); }));
  EXPECT_EQ(noise(), "");
  line("keep_edges machined");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 2; }));
  EXPECT_EQ(kept_edges(), "machined");
}

TEST_F(FrontService, AScriptWaitsForTheNoiseBeforeItsNextLine) {
  ASSERT_TRUE(open_part());
  replay("join clean\nkeep_edges auto\nbeta 0.5\n");
  ASSERT_TRUE(until([this] { return has_message("replayed one.script") && is_settled(); }));
  ASSERT_TRUE(until([this] { return document()["history"].size() == 3; }));
  EXPECT_THAT(document()["history"][0].dump(), HasSubstr("beta"));
}

TEST_F(FrontService, AScriptEndsAtANoiseThatCannotBeMeasured) {
  ASSERT_TRUE(open_part());
  lose_originals();
  replay("join clean\nkeep_edges auto\nbeta 0.5\n");
  EXPECT_TRUE(until([this] { return has_message("one.script:2: keep_edges"); }));
}

TEST_F(FrontService, TheCommandKeepsEdgesByTheNoiseThatItSays) {
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

TEST_F(FrontService, ARecordedScriptReplaysTheEdits) {
  ASSERT_TRUE(open());
  line("record start");
  ASSERT_TRUE(until([this] { return snapshot_["recording"] == true; }));
  line("beta 0.25");
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 1; }));
  line("record stop");
  const std::string script = downloads_["work.script"];
  EXPECT_THAT(script, HasSubstr("join work"));
  EXPECT_THAT(script, HasSubstr("beta 0.25"));
  given_["work.script"] = script;
  hear({{"kind", "replay"},
        {"file", {{"handle", 1}, {"name", "work.script"}, {"size", script.size()}}}});
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 2; }));
}

TEST_F(FrontService, AScriptWhoseSessionIsClosedWhileItWaitsEndsAndSaysSo) {
  ASSERT_TRUE(open());
  const std::string script = given_["work.script"] = "join work\nbeta 0.25\nwait\n";
  meanwhile_ = [this] {
    const Document* const document = front_.workspace().document();
    if (document && document->link() == LinkState::kLive && document->stats().frames > 0)
      front_.workspace().close_document();
  };
  hear({{"kind", "replay"},
        {"file", {{"handle", 1}, {"name", "work.script"}, {"size", script.size()}}}});
  EXPECT_TRUE(until([this] {
    return snapshot_["messages"].dump().find("closed while the script waited") != std::string::npos;
  }));
}

TEST_F(FrontService, AServerThatDoesNotAnswerIsAProblem) {
  hear({{"kind", "start"},
        {"width", 400},
        {"height", 300},
        {"pixelRatio", 1},
        {"address", "http://127.0.0.1:1"},
        {"user", ""},
        {"token", ""}});
  ASSERT_TRUE(until([this] { return snapshot_["library"]["state"] == "failed"; }));
  EXPECT_FALSE(snapshot_["library"]["wantsToken"]);
  EXPECT_THAT(snapshot_["library"]["problem"].get<std::string>(), HasSubstr("127.0.0.1:1"));
}

}  // namespace
}  // namespace burnish

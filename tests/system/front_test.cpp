#include "tests/client/scene/png_description.h"
#include "tests/system/front_service.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

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

TEST_F(FrontService, AScanIsExportedInItsOwnFormatFirst) {
  ASSERT_TRUE(open());
  EXPECT_EQ(document()["formats"], Json({"ply", "obj", "stl", "glb"}));
}

TEST_F(FrontService, AForkWithoutANameIsNamedByTheServer) {
  ASSERT_TRUE(open());
  line("fork");
  ASSERT_TRUE(until([this] {
    return !snapshot_["document"].is_null() && document()["session"] != "work" && is_settled();
  }));
  EXPECT_TRUE(answers_.empty());
  EXPECT_NE(document()["session"], "");
}

TEST_F(FrontService, AScanThatIsGivenInASessionOpens) {
  ASSERT_TRUE(open());
  const std::string file = write_sphere(server_.folder, 2);
  hear({{"kind", "import"}, {"file", {{"handle", 1}, {"name", file}, {"size", 1}}}});
  EXPECT_TRUE(until([this] { return is_settled() && document()["scan"] == "sphere2"; }));
}

TEST_F(FrontService, FiguresAreNotThoseOfTheSurfaceUntilTheyAreMeasuredAgain) {
  ASSERT_TRUE(open());
  ASSERT_TRUE(until([this] { return document()["numbers"]["current"] == true; }));
  const Json still = document()["numbers"]["deviation"];
  line("beta 0");
  ASSERT_TRUE(until([this] { return document()["numbers"]["current"] == false; }));
  EXPECT_EQ(document()["numbers"]["deviation"], still);
  ASSERT_TRUE(until([this] { return document()["numbers"]["current"] == true; }));
  const Json moved = document()["numbers"]["deviation"];
  EXPECT_NE(moved, still);
  EXPECT_EQ(moved[5]["name"], "along y");
  line("up z");
  EXPECT_TRUE(until([this] { return document()["numbers"]["deviation"][5]["name"] == "along z"; }));
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
  EXPECT_THAT(document()["history"][0]["name"].get<std::string>(), HasSubstr("stroke"));
  EXPECT_TRUE(front_.workspace().viewport.last_hover());
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
                           "ruler clear",
                           "unit mm",
                           "split_at 0.3",
                           "lamp 0.2 0.4",
                           "bookmark add",
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
  replay(script);
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() == 2; }));
}

TEST_F(FrontService, AScriptWhoseSessionIsClosedWhileItWaitsEndsAndSaysSo) {
  ASSERT_TRUE(open());
  meanwhile_ = [this] {
    const Document* const document = front_.workspace().document();
    if (document && document->link() == LinkState::kLive && document->stats().frames > 0)
      front_.workspace().close_document();
  };
  replay("join work\nbeta 0.25\nwait\n");
  EXPECT_TRUE(until([this] { return has_message("closed while the script waited"); }));
}

class FrontOfFewTriangles : public FrontService {
 protected:
  FrontOfFewTriangles()
      : FrontService(std::make_unique<NullPageRenderer>(), "", PageBudget{.triangles = 1000}) {}
};

TEST_F(FrontOfFewTriangles, ASavedPictureSaysThatItIsSimplified) {
  ASSERT_TRUE(open());
  line("picture one.png");
  EXPECT_THAT(png_description(downloads_["one.png"]), HasSubstr("simplified, "));
  replay("screenshot two.png\n");
  ASSERT_TRUE(until([this] { return has_message("replayed"); }));
  EXPECT_THAT(png_description(downloads_["two.png"]), HasSubstr("simplified, "));
  for (const char* const saved : {"saved one.png: simplified, ", "saved two.png: simplified, "})
    EXPECT_TRUE(until([&] { return has_message(saved); })) << saved;
}

TEST_F(FrontService, APictureOfFullDetailSaysNothingOfItself) {
  ASSERT_TRUE(open());
  line("picture one.png");
  ASSERT_TRUE(downloads_.contains("one.png"));
  EXPECT_EQ(png_description(downloads_["one.png"]), "");
  EXPECT_FALSE(has_message("simplified"));
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

#include <fstream>

#include "tests/system/front_service.h"
#include "tests/system/process.h"

namespace burnish {
namespace {

/// Has the compiler of the page say what a Snapshot does not have, or lacks.
class SnapshotOfThePage : public FrontService {
 protected:
  std::string complaints() {
    const auto file = server_.folder / "shown.ts";
    std::ofstream(file) << "import type { Snapshot } from \"" SOURCE_ROOT
                           "/client/web/page/src/snapshot\";\nexport const shown: Snapshot = "
                        << snapshot_ << ";\n";
    Process tsc({"/usr/bin/env", "node", SOURCE_ROOT "/node_modules/typescript/bin/tsc", "--noEmit",
                 "--strict", "--module", "esnext", "--moduleResolution", "bundler", file},
                server_.folder / "complaints");
    const auto code = tsc.wait(kPatience);
    return code == 0 ? "" : "tsc says: " + tsc.output();
  }

  void set_ruler(double x) {
    point("press", x, 150);
    point("release", x, 150);
  }
};

TEST_F(SnapshotOfThePage, HasTheTypesThatThePageReads) {
  ASSERT_TRUE(start());
  EXPECT_EQ(complaints(), "") << "on the start page";
  ASSERT_TRUE(open());
  front_.workspace().log.info("one message");
  for (const char* text : {"preset Bring out an inscription 1", "checkpoint here", "mirror x",
                           "palette 50 d9534f soft ; 0:20,5:80 4a7fd0 hard", "colour displacement",
                           "figures on", "tool measure"})
    line(text);
  ASSERT_TRUE(until([this] { return is_settled() && document()["history"].size() > 3; }));
  line("strengths open");
  ASSERT_TRUE(until([this] { return snapshot_["strengths"].is_object(); }));
  EXPECT_EQ(snapshot_["preset"]["hasTrial"], true);
  EXPECT_EQ(complaints(), "") << "with pictures of strengths";
  set_ruler(180);
  set_ruler(220);
  ASSERT_TRUE(until([this] { return document()["numbers"]["rulerPoints"] == 2; }));
  line("section cut");
  ASSERT_TRUE(until([this] {
    return document()["section"].is_object() && document()["section"]["ready"] == true &&
           !document()["people"].empty() && !document()["scale"].is_null() &&
           !document()["figures"].empty() && !document()["numbers"]["deviation"].empty() &&
           !document()["palette"].empty();
  }));
  front_.workspace().viewport.menu = PictureMenu{{200, 150}, Vec3d(1, 2, 3)};
  ASSERT_TRUE(until([this] { return document()["over"]["menu"].is_object(); }));
  EXPECT_EQ(complaints(), "");
}

TEST_F(SnapshotOfThePage, AFieldThatThePageDoesNotKnowIsNamed) {
  ASSERT_TRUE(start());
  snapshot_["library"]["scans"][0]["weight"] = 1;
  EXPECT_THAT(complaints(), testing::HasSubstr("weight"));
  snapshot_["library"]["scans"][0].erase("weight");
  snapshot_["library"]["scans"][0].erase("closed");
  EXPECT_THAT(complaints(), testing::HasSubstr("closed"));
}

}  // namespace
}  // namespace burnish

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/scene/png_reader.h"
#include "common/base/limits.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/client/scene/png_description.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

std::string write_script(const ServerProcess& server, const std::string& text) {
  const auto path = server.folder / "script.txt";
  std::ofstream(path) << text;
  return path.string();
}

CommandOutcome run_script(ServerProcess& server, const std::string& text,
                          std::vector<std::string> more = {}) {
  std::vector<std::string> words = {"window", "--script", write_script(server, text)};
  words.insert(words.end(), more.begin(), more.end());
  return server.burnish(words);
}

TEST(Script, OpensEditsWaitsDrawsAndExports) {
  ServerProcess server;
  const std::string sphere = write_sphere(server.folder, 4);
  const std::string picture = (server.folder / "out.png").string();
  const std::string mesh = (server.folder / "out.ply").string();
  const CommandOutcome outcome = run_script(
      server, "open " + sphere + "  # a comment\nfidelity 5\nbeta 0\nwait\nprint\nscreenshot " +
                  picture + "\nexport " + mesh + "\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("settled, beta 0, curve 0:5"), std::string::npos) << outcome.output;
  EXPECT_GT(std::filesystem::file_size(picture), 1000u);
  // A sphere of radius 1 shrinks by α²/(α² + 2L²), the closed form for its coordinates.
  const auto edited = read_mesh(mesh);
  ASSERT_TRUE(edited.is_ok());
  const double expected = 25 / (25 + 2 * 4 * 3.14159265);
  for (const Vec3d& vertex : edited->vertices) ASSERT_NEAR(vertex.norm(), expected, 2e-3);
}

TEST(Script, APointerStrokeIsOneEntryAndUndoSwitchesItOff) {
  ServerProcess server;
  const std::string sphere = write_sphere(server.folder, 4);
  const CommandOutcome outcome = run_script(
      server, "open " + sphere +
                  "\nsize 640x480\nbrush 0.3 0.8 0\ndrag 300 240 320 240 340 240\nwait\nundo\n"
                  "wait\nprint\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("1 entries"), std::string::npos) << outcome.output;
}

TEST(Script, AFrameFromFartherShowsTheScanSmaller) {
  ServerProcess server;
  const std::string sphere = write_sphere(server.folder, 4);
  const auto after = [&](const std::string& frame) {  // near the edge of the framed sphere
    return run_script(server, "open " + sphere + "\nsize 640x480\nbrush 0.3 0.8 0\n" + frame +
                                  "\ndrag 460 240 465 240\nwait\nprint\n")
        .output;
  };
  EXPECT_NE(after("frame 2").find(" 0 entries"), std::string::npos);
  EXPECT_NE(after("frame").find(" 1 entries"), std::string::npos);
  EXPECT_NE(after("frame 0").find("'0' times the distance is outside 1..10"), std::string::npos);
}

TEST(Script, AMirroredStrokeIsTwoEntriesThatOneUndoTakesBack) {
  ServerProcess server;
  const std::string stroke = "open " + write_sphere(server.folder, 4) +
                             "\nmirror x\nstroke 0.3 0.8 0 smooth 0.5 0 0.8\nwait\nprint\n";
  const CommandOutcome outcome = run_script(server, stroke + "undo\nwait\nprint\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_NE(outcome.output.find(" 2 entries"), std::string::npos) << outcome.output;
  EXPECT_NE(run_script(server, stroke + "mirror w\n").output.find("'w'"), std::string::npos);
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Script, LightUpAxisViewAndProjectionChangeThePicture) {
  ServerProcess server;
  // With hollows, for a ball has no occlusion.
  const std::string blob = (server.folder / "blob.ply").string();
  ASSERT_TRUE(write_mesh(generate_scan({"blob", 3000, 1}).value(), blob).is_ok());
  std::string script = "open " + blob + "\nsize 300x200\nflat on\n";
  std::vector<std::filesystem::path> pictures;
  for (const std::string change : {"light clay", "light radiance", "occlusion 1", "up z",
                                   "view right", "orthographic on", "light_direction 0 10"}) {
    pictures.push_back(server.folder / (std::to_string(pictures.size()) + ".png"));
    script += change + "\nscreenshot " + pictures.back().string() + "\n";
  }
  const CommandOutcome outcome = run_script(server, script);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  for (size_t i = 1; i < pictures.size(); ++i)
    EXPECT_NE(content_of(pictures[i]), content_of(pictures[i - 1])) << i;
}

TEST(Script, APictureHasAScaleBarWhileTheScriptWantsOne) {
  ServerProcess server;
  std::string script = "open " + write_sphere(server.folder, 3) + "\nsize 300x200\n";
  for (const std::string change : {"scale_bar off", "scale_bar on", "scale_bar off"})
    script += change + "\nscreenshot " + (server.folder / change).string() + ".png\n";
  script += "scale_bar perhaps\n";
  const CommandOutcome outcome = run_script(server, script);
  EXPECT_THAT(outcome.output, testing::HasSubstr("perhaps"));
  const auto read = [&](const std::string& name) {
    return read_png(server.folder / name, kImageSidePixelsMax).value();
  };
  const Image plain = read("scale_bar off.png"), barred = read("scale_bar on.png");
  int changed = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 300; ++x) {
      const bool differs =
          !std::equal(plain.pixel(x, y), plain.pixel(x, y) + 3, barred.pixel(x, y));
      changed += differs;
      EXPECT_TRUE(!differs || (x >= 200 && y >= 180)) << x << " " << y;
    }
  EXPECT_GT(changed, 500);
}

TEST(Script, APictureWithoutFullDetailSaysSo) {
  ServerProcess server;
  const auto picture = server.folder / "a.png";
  const std::string script =
      "open " + write_sphere(server.folder, 4) + "\nscreenshot " + picture.string() + "\n";
  const CommandOutcome outcome = run_script(server, script, {"--triangles", "1000"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(png_description(content_of(picture)), testing::HasSubstr("simplified, "));
  EXPECT_THAT(outcome.output, testing::HasSubstr("warning: saved " + picture.string()));
  EXPECT_EQ(run_script(server, script).exit_code, 0);
  EXPECT_EQ(png_description(content_of(picture)), "");
}

TEST(Script, ACameraThatIsPlacedStaysWhenThePictureGetsAnotherSize) {
  ServerProcess server;
  const std::string open = "open " + write_sphere(server.folder, 4) + "\n";
  const std::string camera = "camera 25 20 2.5 0.1 0.2 0\n", size = "size 500x350\n";
  const auto picture = [&](const std::string& name) { return server.folder / name; };
  const CommandOutcome outcome = run_script(
      server, open + camera + size + "screenshot " + picture("a.png").string() + "\nframe\n" +
                  size + camera + "screenshot " + picture("b.png").string() + "\nframe\n" + size +
                  "screenshot " + picture("c.png").string() + "\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(content_of(picture("a.png")), content_of(picture("b.png")));
  EXPECT_NE(content_of(picture("a.png")), content_of(picture("c.png")));
}

TEST(Script, ACameraTakesItsTargetWholeOrNotAtAll) {
  ServerProcess server;
  const std::string open = "open " + write_sphere(server.folder, 3) + "\n";
  for (const char* numbers : {"1 2 3 4", "1 2 3 4 5"}) {
    const CommandOutcome outcome = run_script(server, open + "camera " + numbers + "\n");
    EXPECT_NE(outcome.exit_code, 0) << numbers;
    EXPECT_THAT(outcome.output, testing::HasSubstr("with a target 6"));
  }
  EXPECT_EQ(run_script(server, open + "camera 1 2\ncamera 1 2 3\n").exit_code, 0);
}

TEST(Script, KeepingNoEdgesTakesTheirFidelityBack) {
  ServerProcess server;
  const CommandOutcome outcome =
      run_script(server, "open " + write_sphere(server.folder, 3) +
                             "\nfidelity 30\nwait\nprint\nkeep_edges soft\nwait\nprint\n"
                             "keep_edges off\nwait\nprint\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  std::vector<std::string> curves;
  for (size_t at = 0; (at = outcome.output.find(", curve ", at)) != std::string::npos; ++at)
    curves.push_back(outcome.output.substr(at, outcome.output.find(", ", at + 1) - at));
  ASSERT_EQ(curves.size(), 3u) << outcome.output;
  EXPECT_NE(curves[1], curves[0]);
  EXPECT_EQ(curves[2], curves[0]);
}

TEST(Script, UndoAndRedoTakeAWholePreset) {
  ServerProcess server;
  const std::string script = "open " + write_sphere(server.folder, 3) +
                             "\nbeta 0.5\nwait\npreset Sharpen grooves\nwait\nprint\nundo\nwait\n"
                             "print\nredo\nwait\nprint\n";
  const CommandOutcome outcome = run_script(server, script);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (size_t at = 0; (at = outcome.output.find(text, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("beta 3,"), 2) << outcome.output;
  EXPECT_EQ(count("beta 0.5, curve 0:50,"), 1) << outcome.output;
}

TEST(Script, ControlsProtectionAndStrengthAreEdits) {
  ServerProcess server;
  const std::string script = "open " + write_sphere(server.folder, 3) +
                             "\ncontrols off 0.25 on\nprotect curvature -5 5\nprotect grow 2\n"
                             "preset Bring out an inscription 0.5\nwait\nprint\n";
  const CommandOutcome outcome = run_script(server, script);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, testing::HasSubstr(":1.75,"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("6 entries"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("rims free, at most 0.25, volume kept"));
}

TEST(Script, BandsPaletteAndWhatABrushPaintsAreEdits) {
  ServerProcess server;
  const std::string script =
      "open " + write_sphere(server.folder, 3) +
      "\nbands 0.5:2 2:0.5\npalette 80 d04040 fine letters ; 20 4060d0 ground\n"
      "stroke 0.4 1 3 smooth band:2 through 0 0 1\nstroke 0.4 1 0 smooth curve:1 0 1 "
      "0\nwait\nprint\n"
      "bands\nwait\nprint\n";
  const CommandOutcome outcome = run_script(server, script);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, testing::HasSubstr("bands 0.5:2 2:0.5, palette of 2 curves"));
  EXPECT_THAT(outcome.output, testing::HasSubstr("no bands, palette of 2 curves"));
}

TEST(Script, KeptEdgesAreEdits) {
  ServerProcess server;
  const std::string script = "open " + write_sphere(server.folder, 3) +
                             "\nkeep_edges scanner\nwait\nprint\n"
                             "edges edges 0.5 20 3 0.25\nwait\nprint\n"
                             "keep_edges off\nwait\nprint\n";
  const CommandOutcome outcome = run_script(server, script);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const auto scanner =
      outcome.output.find("edges kept at strength 1, angle 35, 20 passes, crispness 1\n");
  ASSERT_NE(scanner, std::string::npos) << outcome.output;
  EXPECT_GT(outcome.output.find(
                "edges kept at strength 0.5, angle 20, 3 passes, crispness 0.25, machined\n"),
            scanner);
  EXPECT_THAT(outcome.output.substr(outcome.output.rfind("beta")),
              testing::Not(testing::HasSubstr("edges")));
  EXPECT_THAT(
      run_script(server, "open " + write_sphere(server.folder, 3) + "\nedges soft\n").output,
      testing::HasSubstr("FILTER STRENGTH ANGLE PASSES CRISPNESS"));
}

TEST(Script, EdgesAreKeptAsTheScansNoiseAsksOrStay) {
  ServerProcess server;
  const std::string part = (server.folder / "part.ply").string();
  const auto noisy = generate_scan({"part", 4000, 1, 0.2, NoiseKind::kGauss});
  ASSERT_TRUE(write_mesh(noisy.value(), part).is_ok());
  const std::string kept = run_script(server, "open " + part + "\nkeep_edges auto\nprint\n").output;
  EXPECT_THAT(kept, testing::HasSubstr("edges kept at strength 1, angle 35, 10 passes"));
  const CommandOutcome quiet = run_script(
      server, "open " + write_sphere(server.folder, 4) + "\nkeep_edges auto\nwait\nprint\n");
  EXPECT_EQ(quiet.exit_code, 0) << quiet.output;
  EXPECT_THAT(quiet.output, testing::HasSubstr(" 0 entries"));
}

std::string write_red_sphere(const ServerProcess& server) {
  TriangleMesh mesh = make_icosphere(4, 1);
  mesh.colours.assign(mesh.vertices.size(), Rgba8{200, 10, 10, 255});
  const auto path = server.folder / "red.ply";
  EXPECT_TRUE(write_mesh(mesh, path).is_ok());
  return path.string();
}

TEST(Script, AScanWithColoursShowsThemAtFirst) {
  ServerProcess server;
  const auto screenshot_to = [&](const std::string& name) {
    return "screenshot " + (server.folder / name).string() + "\n";
  };
  const CommandOutcome outcome =
      run_script(server, "open " + write_red_sphere(server) + "\n" + screenshot_to("first.png") +
                             "colour clay\n" + screenshot_to("clay.png") + "colour scan\n" +
                             screenshot_to("scan.png"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(content_of(server.folder / "first.png"), content_of(server.folder / "scan.png"));
  EXPECT_NE(content_of(server.folder / "first.png"), content_of(server.folder / "clay.png"));
  const CommandOutcome plain =
      run_script(server, "open " + write_sphere(server.folder, 3) + "\ncolour scan\n");
  EXPECT_EQ(plain.exit_code, 1);
  EXPECT_NE(plain.output.find("no colours"), std::string::npos) << plain.output;
}

TEST(Script, WhatIsRecordedDoesTheSameAgain) {
  ServerProcess server;
  const std::string sphere = write_sphere(server.folder, 4);
  const std::string record = (server.folder / "record.txt").string();
  ASSERT_EQ(run_script(server,
                       "open " + sphere +
                           "\nbeta 0.25\ncurve -5:10,5:100\nbrush 0.3 0.8 2\n"
                           "drag 600 480 640 480 680 480\nwait\n",
                       {"--record", record})
                .exit_code,
            0);
  std::ifstream file(record);
  std::string lines{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(lines.find("beta 0.25\n"), std::string::npos) << lines;
  EXPECT_NE(lines.find("stroke 0.3 0.8 2 smooth "), std::string::npos) << lines;
  const CommandOutcome again = run_script(server, lines + "wait\nprint\n");
  ASSERT_EQ(again.exit_code, 0) << again.output;
  EXPECT_NE(again.output.find("beta 0.25, curve -5:10,5:100, 6 entries"), std::string::npos)
      << again.output;
}

TEST(Script, AnEditThatCouldNotBeSavedIsAFailure) {
  ServerProcess server;
  ASSERT_EQ(server.burnish({"import", write_sphere(server.folder), "--name", "ball"}).exit_code, 0);
  ASSERT_EQ(server.burnish({"open", "ball", "--session", "work"}).exit_code, 0);
  server.kill();
  setenv("LD_PRELOAD", DIE_AT_LIBRARY, 1);
  setenv("BURNISH_DIE_AT", "before log sync", 1);  // a hierarchy may be kept before
  setenv("BURNISH_DIE_COUNT", "1", 1);
  server.start();
  unsetenv("LD_PRELOAD");
  server.arm_fault();
  const CommandOutcome outcome = run_script(server, "join work\nbeta 0.5\n", {"--timeout", "3"});
  EXPECT_EQ(server.process->wait(kPatience), 128 + SIGKILL);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_NE(outcome.output.find("1 edit is not saved and will be lost"), std::string::npos)
      << outcome.output;
}

TEST(Script, ItsLastEditIsSavedThoughItDoesNotWait) {
  ServerProcess server;
  const std::string sphere = write_sphere(server.folder);
  ASSERT_EQ(run_script(server, "open " + sphere + "\nbeta 0.5\n").exit_code, 0);
  const CommandOutcome sessions = server.burnish({"sessions", "--json"});
  EXPECT_NE(sessions.output.find("\"edits\": 1,"), std::string::npos) << sessions.output;
}

TEST(Script, AWrongLineIsNamedBeforeAnythingIsDone) {
  ServerProcess server;
  const CommandOutcome unknown = run_script(server, "open x.ply\npolish 3\n");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_NE(unknown.output.find("script.txt:2: unknown command 'polish'"), std::string::npos)
      << unknown.output;
  const CommandOutcome value = run_script(server, "beta 0.5\n");
  EXPECT_EQ(value.exit_code, 1);
  EXPECT_NE(value.output.find("script.txt:1: beta: no session is open"), std::string::npos)
      << value.output;
}

}  // namespace
}  // namespace burnish

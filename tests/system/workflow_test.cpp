#include <csignal>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Runs a command that must succeed.
std::string done(ServerProcess& server, std::vector<std::string> words) {
  const CommandOutcome outcome = server.burnish(std::move(words));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  return outcome.output;
}

json done_json(ServerProcess& server, std::vector<std::string> words) {
  words.push_back("--json");
  const std::string output = done(server, std::move(words));
  return json::parse(output.substr(output.find_first_of("[{")));
}

/// Returns the mean distance of the vertices from the origin.
double mean_radius(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Vec3d& vertex : mesh.vertices) sum += vertex.norm();
  return sum / static_cast<double>(mesh.vertices.size());
}

TEST(Workflow, AScanGoesInAndComesOutEdited) {
  ServerProcess server;
  const std::string scan = write_sphere(server.folder, 4);
  const std::string out = (server.folder / "out.ply").string();

  EXPECT_THAT(done(server, {"import", scan, "--depth", "5", "--name", "ball"}),
              HasSubstr("imported ball"));
  EXPECT_THAT(done(server, {"meshes"}), HasSubstr("ball"));
  const json described = done_json(server, {"describe", "ball"});
  EXPECT_EQ(described["vertices"], 2562);
  EXPECT_EQ(described["boundary_edges"], 0);
  EXPECT_EQ(described["components"], 1);
  EXPECT_EQ(described["described"]["depth"], 5);
  EXPECT_EQ(described["described"]["histogram"]["area"].size(), 128u);

  done(server, {"open", "ball", "--depth", "5", "--session", "work"});
  const std::string strokes =
      server.folder.write("strokes.txt", "brush 0.4 1 3 smooth\n0 0 1\n0 0.3 0.95\n").string();
  const json edited = done_json(server, {"edit", "work", "--curve", "-20:5,20:5", "--beta", "0",
                                         "--stroke", strokes, "--id", "first"});
  EXPECT_EQ(edited["applied"], 3);
  EXPECT_EQ(done_json(server, {"edit", "work", "--curve=-20:5,20:5", "--beta", "0", "--stroke",
                               strokes, "--id", "first"})["known"],
            3);
  EXPECT_EQ(done_json(server, {"sessions", "work"})["beta"], 0);

  done(server, {"edit", "work", "--cap", "0.25", "--keep-volume", "on"});
  EXPECT_THAT(done(server, {"protect", "work", "piece", "0", "0", "1"}),
              HasSubstr("protect piece"));
  done(server, {"protect", "work", "clear"});
  done(server, {"edit", "work", "--keep-volume", "off"});
  const json controls = done_json(server, {"sessions", "work"})["controls"];
  EXPECT_EQ(controls["pin_rims"], true) << "as a new session has it";
  EXPECT_EQ(controls["cap"], 0.25);
  EXPECT_EQ(controls["keep_volume"], false);

  const json summary = done_json(server, {"export", "work", out, "--exact"});
  EXPECT_EQ(summary["vertices"], 2562);
  EXPECT_TRUE(summary["converged"]);
  const TriangleMesh before = read_mesh(scan).value();
  const TriangleMesh after = read_mesh(out).value();
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_LT(mean_radius(after), mean_radius(before));

  const CommandOutcome refused = server.burnish({"delete", "ball"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("session work edits scan ball"));
  done(server, {"close", "work", "--delete"});
  done(server, {"delete", "ball"});
  EXPECT_EQ(done_json(server, {"meshes"}).size(), 0u);
  EXPECT_EQ(server.scans(), 0u);
}

TEST(Workflow, WallsThinnerThanACellAreToldOfScanAndSession) {
  ServerProcess server;
  const auto scan = server.folder / "sheets.ply";
  ASSERT_TRUE(write_mesh(generate_scan({"sheets", 2000, 1}).value(), scan).is_ok());
  done(server, {"import", scan.string(), "--depth", "5", "--name", "sheets"});
  done(server, {"open", "sheets", "--depth", "5", "--session", "work"});
  const auto is_told = HasSubstr("Walls: 100 % of the surface is thinner than a cell");
  EXPECT_THAT(done(server, {"describe", "sheets"}), is_told);
  EXPECT_THAT(done(server, {"sessions", "work"}), is_told);
  const json walls = done_json(server, {"sessions", "work"})["walls"];
  EXPECT_GT(walls["share"], 0.9);
  EXPECT_GT(walls["depth"], 5);
  EXPECT_EQ(done_json(server, {"describe", "sheets"})["described"]["walls"], walls);
  done(server, {"import", write_sphere(server.folder, 3), "--depth", "5", "--name", "ball"});
  EXPECT_THAT(done(server, {"describe", "ball"}), testing::Not(HasSubstr("Walls")));
  EXPECT_TRUE(done_json(server, {"describe", "ball"})["described"]["walls"].is_null());
}

TEST(Workflow, AGlbGoesInAndComesOutAsItWas) {
  ServerProcess server;
  const std::string ply = write_sphere(server.folder, 3);
  const std::string scan = (server.folder / "ball.glb").string();
  ASSERT_TRUE(write_mesh(read_mesh(ply).value(), scan).is_ok());
  EXPECT_THAT(done(server, {"import", scan, "--depth", "5"}), HasSubstr("imported ball"));
  EXPECT_EQ(done_json(server, {"meshes"})[0]["format"], "glb");
  done(server, {"open", "ball", "--depth", "5", "--session", "work"});
  const std::string out = (server.folder / "out.glb").string();
  done(server, {"export", "work", out});
  EXPECT_EQ(content_of(out), content_of(scan));
  done(server, {"edit", "work", "--beta", "0"});
  done(server, {"export", "work", out});
  EXPECT_LT(mean_radius(read_mesh(out).value()), mean_radius(read_mesh(scan).value()));
}

TEST(Workflow, BandsAndPaintedCurvesAreEditsAndGiveTheFilesOfFilter) {
  ServerProcess server;
  const std::string scan = write_sphere(server.folder);
  const std::string served = (server.folder / "served.ply").string();
  const std::string filtered = (server.folder / "filtered.ply").string();
  const std::string palette =
      server.folder.write("palette.txt", "80 d04040 letters\n20 4060d0 soft stone\n").string();
  const std::string strokes =
      server.folder
          .write("strokes.txt",
                 "brush 0.6 1 0 constant band:2\n0 0 1\nbrush 0.8 1 0 smooth curve:1\n0 1 0\n")
          .string();
  const std::vector<std::string> changes = {"--beta", "0.5",   "--band",    "0.5:2",
                                            "--band", "2:0.5", "--palette", palette};
  done(server, {"import", scan, "--depth", "5", "--name", "ball"});
  done(server, {"open", "ball", "--depth", "5", "--session", "work"});
  std::vector<std::string> edit = {"edit", "work", "--stroke", strokes};
  edit.insert(edit.end(), changes.begin(), changes.end());
  EXPECT_EQ(done_json(server, edit)["applied"], 5);
  const json state = done_json(server, {"sessions", "work"});
  EXPECT_EQ(state["bands"], json::parse(R"([{"size": 0.5, "gain": 2}, {"size": 2, "gain": 0.5}])"));
  EXPECT_EQ(state["palette"][1]["name"], "soft stone");
  done(server, {"close", "work"});
  done(server, {"export", "work", served, "--exact"});
  std::vector<std::string> filter = {"filter", scan,      filtered,       "--depth",
                                     "5",      "--exact", "--beta-paint", strokes};
  filter.insert(filter.end(), changes.begin(), changes.end());
  filter.insert(filter.begin(), BURNISH_BINARY);
  Process filtering(filter, server.folder / "filtering");
  ASSERT_EQ(filtering.wait(std::chrono::minutes(1)), 0) << filtering.output();
  const TriangleMesh a = read_mesh(served).value(), b = read_mesh(filtered).value();
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (size_t v = 0; v < a.vertices.size(); ++v)
    ASSERT_LT((a.vertices[v] - b.vertices[v]).norm(), 3e-6);
}

TEST(Workflow, ColoursAreFilteredOutlastTheServerAndComeBack) {
  ServerProcess server;
  TriangleMesh sphere = make_icosphere(4, 1);
  for (size_t v = 0; v < sphere.vertices.size(); ++v)
    sphere.colours.push_back(v % 2 == 0 ? Rgba8{200, 90, 30, 255} : Rgba8{60, 90, 30, 255});
  const std::string scan = (server.folder / "spotted.ply").string();
  const std::string out = (server.folder / "out.ply").string();
  ASSERT_TRUE(write_mesh(sphere, scan).is_ok());
  done(server, {"import", scan, "--depth", "6", "--name", "spotted"});
  done(server, {"open", "spotted", "--depth", "6", "--session", "work"});
  done(server, {"edit", "work", "--colour-beta", "0", "--colour-alpha", "20"});
  EXPECT_EQ(done_json(server, {"sessions", "work"})["colours"]["alpha"], 20);
  server.kill();
  server.start();
  done(server, {"export", "work", out});
  const TriangleMesh even = read_mesh(out).value(), before = read_mesh(scan).value();
  EXPECT_EQ(even.vertices, before.vertices);
  for (const Rgba8& colour : even.colours) {
    ASSERT_NEAR(colour[0], 149, 12);  // of the mean of 200 and 60 in linear light
    ASSERT_NEAR(colour[1], 90, 1);
  }
  done(server, {"undo", "work"});
  done(server, {"export", "work", out});
  EXPECT_EQ(content_of(out), content_of(scan));
}

TEST(Workflow, ImportingTheSameBytesTwiceSaysSo) {
  ServerProcess server;
  const std::string scan = write_sphere(server.folder);
  done(server, {"import", scan, "--depth", "5"});
  EXPECT_THAT(
      done(server, {"import", scan, "--depth", "5", "--name", "other"}),
      testing::AllOf(HasSubstr("already there: sphere3"), HasSubstr("burnish rename scan")));
  const std::string copy = (server.folder / "copy.ply").string();
  std::filesystem::copy_file(scan, copy);
  EXPECT_THAT(done(server, {"import", copy, "--depth", "5", "--json"}),
              HasSubstr("keeps its name sphere3. To change it: burnish rename scan"));
  EXPECT_THAT(done(server, {"import", scan, "--depth", "5"}), testing::Not(HasSubstr("keeps")));
  EXPECT_EQ(done_json(server, {"meshes"}).size(), 1u);
}

TEST(Workflow, AScanAndASessionTakeANewName) {
  ServerProcess server;
  done(server, {"import", write_sphere(server.folder), "--depth", "5", "--name", "ball"});
  done(server, {"open", "ball", "--depth", "5", "--session", "work"});
  EXPECT_THAT(done(server, {"rename", "scan", "ball", "globe"}), HasSubstr("globe"));
  EXPECT_EQ(done_json(server, {"rename", "session", "work", "carving"})["name"], "carving");
  EXPECT_EQ(done_json(server, {"meshes"})[0]["name"], "globe");
  EXPECT_EQ(done_json(server, {"sessions"})[0]["name"], "carving");
  const CommandOutcome unknown = server.burnish({"rename", "session", "work", "other"});
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_THAT(unknown.output, HasSubstr("work"));
  EXPECT_EQ(server.burnish({"rename", "user", "ada", "eve"}).exit_code, 2);
}

TEST(Workflow, CellFieldsOfManyCellsTravelInParts) {
  ServerProcess server;
  done(server, {"import", write_sphere(server.folder), "--depth", "8", "--name", "ball"});
  done(server, {"open", "ball", "--depth", "8", "--session", "work"});
  std::string cells;
  for (int i = 0; i < 70'000; ++i) cells += "0 0 0 5 5 1\n";
  const std::string file = server.folder.write("cells.txt", cells).string();
  const CommandOutcome outcome = server.burnish({"edit", "work", "--cell-field", file});
  EXPECT_EQ(outcome.exit_code, 1);  // the cube's least cell is empty: the server saw the cells
  EXPECT_THAT(outcome.output, HasSubstr("cell 0 0 0"));

  done(server, {"open", "ball", "--depth", "4", "--session", "coarse"});
  const CommandOutcome beyond = server.burnish({"edit", "coarse", "--cell-field", file});
  EXPECT_EQ(beyond.exit_code, 1);
  EXPECT_THAT(beyond.output, HasSubstr("the edit sets 70000 cells, session coarse has"));
}

TEST(Workflow, AKilledServerLosesNoAcknowledgedEdit) {
  ServerProcess server;
  done(server, {"import", write_sphere(server.folder), "--depth", "5", "--name", "ball"});
  done(server, {"open", "ball", "--depth", "5", "--session", "work"});
  done(server, {"edit", "work", "--beta", "0.25", "--alpha", "7"});
  server.kill();

  server.start();
  const json state = done_json(server, {"sessions", "work"});
  EXPECT_EQ(state["edits"], 2);
  EXPECT_EQ(state["beta"], 0.25);
  EXPECT_EQ(state["curve"], "0:7");
  const std::string out = (server.folder / "out.stl").string();
  done(server, {"export", "work", out});
  EXPECT_TRUE(read_mesh(out).is_ok());
}

TEST(Workflow, AKilledUploadLeavesNoHalfWrittenScan) {
  ServerProcess server;
  const std::string scan = write_sphere(server.folder, 7);
  const auto import = server.start_burnish({"import", scan, "--name", "half"});
  ASSERT_TRUE(import->wait_for_output("uploading", kPatience)) << import->output();
  import->signal(SIGKILL);
  import->wait(kPatience);
  for (int i = 0; i < 1000 && server.staged() > 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(server.staged(), 0u);
  EXPECT_EQ(server.scans(), 0u);
}

TEST(Workflow, ATerminatedServerEndsWith0) {
  ServerProcess server;
  done(server, {"meshes"});
  server.process->signal(SIGTERM);
  EXPECT_EQ(server.process->wait(kPatience), 0) << server.process->output();
}

}  // namespace
}  // namespace burnish

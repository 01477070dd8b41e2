// `burnish publish` against a real server: what it writes, and what it refuses.
// tests/client/web/live shows the folder in a browser.

#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "client/publish/publication.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/server/prepare/sheets/photo_archive.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A server with a session of an edited sphere.
class Publish : public testing::Test {
 protected:
  void begin(int level = 4) {
    const std::string sphere = write_sphere(server.folder, level);
    must({"import", sphere, "--name", "ball"});
    must({"open", "ball", "--session", "smooth"});
    must({"edit", "smooth", "--beta", "0.2"});
  }

  std::string must(const std::vector<std::string>& words) {
    const CommandOutcome done = server.burnish(words);
    EXPECT_EQ(done.exit_code, 0) << words.front() << ": " << done.output;
    return done.output;
  }

  std::string path(const std::string& name) const { return (server.folder / name).string(); }

  /// Returns what lies around the target, hidden folders too, but for what the test wrote itself.
  std::vector<std::string> remains() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(server.folder.path()))
      if (entry.path().filename().string().find("site") != std::string::npos &&
          entry.is_directory())
        names.push_back(entry.path().filename().string());
    return names;
  }

  nlohmann::json scan_of(const std::string& folder) const {
    return nlohmann::json::parse(content_of(server.folder / (folder + "/scan.json")));
  }

  /// Returns the lengths of the parts of a publication.
  std::vector<uint32_t> lengths_in(const std::string& folder) const {
    const auto name = scan_of(folder)["parts"]["index"].get<std::string>();
    const std::string index = content_of(server.folder / (folder + "/" + name));
    std::vector<uint32_t> lengths(index.size() / sizeof(uint32_t));
    std::memcpy(lengths.data(), index.data(), index.size());
    return lengths;
  }

  /// Returns the parts of a publication's pages, and those of its sheets.
  std::pair<std::string, std::string> parts_in(const std::string& folder) const {
    const nlohmann::json parts = scan_of(folder)["parts"];
    const std::vector<uint32_t> lengths = lengths_in(folder);
    const size_t of_pages = parts["blocks"].get<size_t>() + 4 * parts["pages"].get<size_t>();
    const auto end = lengths.begin() + static_cast<ptrdiff_t>(of_pages);
    const size_t bytes = std::accumulate(lengths.begin(), end, size_t{0});
    const std::string all =
        content_of(server.folder / (folder + "/" + parts["file"].get<std::string>()));
    return {all.substr(0, bytes), all.substr(bytes)};
  }

  ServerProcess server;
};

TEST_F(Publish, WritesAFolderWhoseIndexAddsUpToItsParts) {
  begin();
  must({"publish", "smooth", path("site"), "--title", "A ball", "--credit", "CC BY 4.0"});
  const nlohmann::json scan = scan_of("site");
  EXPECT_EQ(scan["title"], "A ball");
  EXPECT_EQ(scan["credit"], "CC BY 4.0");
  EXPECT_EQ(scan["triangles"], 5120);
  EXPECT_EQ(scan["record"]["session"], "smooth");
  EXPECT_GT(scan["record"]["deviation"]["max"], 0);
  const nlohmann::json& parts = scan["parts"];
  const std::vector<uint32_t> lengths = lengths_in("site");
  EXPECT_EQ(lengths.size(), parts["blocks"].get<size_t>() + 4 * parts["pages"].get<size_t>());
  uint64_t sum = 0;
  for (const uint32_t length : lengths) sum += length;
  EXPECT_EQ(sum, fs::file_size(server.folder / ("site/" + parts["file"].get<std::string>())));
  for (const char* file : {"index.html", "assets/page.js", "assets/core.packed"})
    EXPECT_TRUE(fs::exists(server.folder / (std::string("site/") + file))) << file;
}

TEST_F(Publish, HasTheColoursAndTheGainsOfAPage) {
  TriangleMesh mesh = make_icosphere(4, 1);
  for (const Vec3d& vertex : mesh.vertices)
    mesh.colours.push_back(
        {static_cast<uint8_t>(128 + 100 * std::sin(40 * vertex.x())), 90, 60, 255});
  const fs::path file = server.folder / "painted.ply";
  ASSERT_TRUE(write_mesh(mesh, file).is_ok());
  must({"import", file.string(), "--name", "painted"});
  must({"open", "painted", "--session", "vivid"});
  must({"edit", "vivid", "--texture-gain", "2"});
  must({"publish", "vivid", path("site")});
  const std::vector<uint32_t> lengths = lengths_in("site");
  const size_t page = scan_of("site")["parts"]["blocks"];
  ASSERT_GE(lengths.size(), page + 4);
  EXPECT_GT(lengths[page], 0u);
  EXPECT_EQ(lengths[page + 1], 0u) << "the surface has not moved";
  EXPECT_GT(lengths[page + 2], 0u) << "its colours have changed";
  EXPECT_GT(lengths[page + 3], 0u) << "and so have the gains of its texels";
}

TEST_F(Publish, OfASessionThatLevelsSeamsHasLevelSheets) {
  const std::vector<uint8_t> zip = zip_of(PhotoGrid());
  std::ofstream(server.folder / "photos.zip", std::ios::binary)
      .write(reinterpret_cast<const char*>(zip.data()), static_cast<std::streamsize>(zip.size()));
  must({"import", path("photos.zip"), "--name", "photos"});
  must({"open", "photos", "--session", "level"});
  must({"publish", "level", path("site1")});
  must({"edit", "level", "--edit", "texture 1 0 1"});
  must({"publish", "level", path("site2")});
  must({"undo", "level"});
  must({"publish", "level", path("site3")});
  const auto own = parts_in("site1"), levelled = parts_in("site2"), again = parts_in("site3");
  EXPECT_FALSE(own.second.empty());
  EXPECT_TRUE(levelled.first == own.first);
  EXPECT_FALSE(levelled.second == own.second);
  EXPECT_TRUE(again == own);
}

TEST_F(Publish, OfTheSameSurfaceHasTheSameParts) {
  begin();
  must({"publish", "smooth", path("site1")});
  must({"publish", "smooth", path("site2")});
  EXPECT_EQ(scan_of("site1")["parts"], scan_of("site2")["parts"]);
}

TEST_F(Publish, NamesTheSessionsWhereThereIsNoSuch) {
  begin(3);
  const CommandOutcome refused = server.burnish({"publish", "smoth", path("site")});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("the server has smooth"));
  EXPECT_THAT(remains(), IsEmpty());
}

TEST_F(Publish, ReplacesAnEarlierPublicationAndNoOtherFolder) {
  begin(3);
  must({"publish", "smooth", path("site")});
  const CommandOutcome refused = server.burnish({"publish", "smooth", path("site")});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("is not empty; --replace"));
  must({"publish", "smooth", path("site"), "--replace", "--title", "Anew"});
  EXPECT_EQ(scan_of("site")["title"], "Anew");
  fs::create_directory(server.folder / "other");
  server.folder.write("other/thesis.txt", "years of work");
  const CommandOutcome other = server.burnish({"publish", "smooth", path("other"), "--replace"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.output, HasSubstr("has no scan.json of a publication"));
  EXPECT_EQ(content_of(server.folder / "other/thesis.txt"), "years of work");
  server.folder.write("other/scan.json", "{\"scanner\": \"mine\"}");
  EXPECT_EQ(server.burnish({"publish", "smooth", path("other"), "--replace"}).exit_code, 1);
  server.folder.write("site/thesis.txt", "years of work");
  const CommandOutcome mixed = server.burnish({"publish", "smooth", path("site"), "--replace"});
  EXPECT_EQ(mixed.exit_code, 1);
  EXPECT_THAT(mixed.output, HasSubstr("has thesis.txt, which no publication has"));
}

TEST_F(Publish, RefusesATitleWithControlCharacters) {
  const CommandOutcome refused =
      server.burnish({"publish", "smooth", path("site"), "--title", "two\nlines"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("the title has control characters"));
}

TEST_F(Publish, LeavesNothingWhereTheDiskIsFull) {
  begin();
  Process full({BURNISH_BINARY, "publish", "smooth", path("site"), "--server", server.address},
               server.folder / "full.txt", {.file_bytes_max = 40'000, .address_bytes_max = {}});
  EXPECT_EQ(full.wait(kPatience), 1);
  EXPECT_THAT(full.output(), HasSubstr("File too large"));
  EXPECT_THAT(remains(), IsEmpty());
}

TEST_F(Publish, LeavesNothingWhenItIsCancelled) {
  begin();
  auto connection = Connection::open(server.address, kPatience);
  ASSERT_TRUE(connection.is_ok());
  const auto stop_at_pages = [](std::string_view phase, double) {
    return phase != "publishing pages";
  };
  const PublishWish wish{.session = "smooth", .folder = path("site"), .title = {}, .credit = {}};
  EXPECT_EQ(publish(*connection, wish, stop_at_pages).status().code(), StatusCode::kCancelled);
  EXPECT_THAT(remains(), IsEmpty());
}

// A new session of so many triangles solves for seconds before its surface rests.
TEST_F(Publish, LeavesNothingAfterCtrlC) {
  begin(7);
  const auto command = server.start_burnish({"publish", "smooth", path("site")});
  ASSERT_TRUE(command->wait_for_output("waiting for the surface", kPatience));
  command->signal(SIGINT);
  EXPECT_EQ(command->wait(kPatience), 1);
  EXPECT_THAT(command->output(), HasSubstr("cancelled"));
  EXPECT_THAT(remains(), IsEmpty());
}

}  // namespace
}  // namespace burnish

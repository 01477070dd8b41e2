// `burnish watch`: a folder whose files are filtered as they come.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/base/check.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::chrono::minutes kWatchPatience{2};

class WatchFolder : public testing::Test {
 protected:
  WatchFolder() { fs::create_directory(folder_ / "in"); }

  fs::path in(const std::string& name) const { return folder_ / "in" / name; }
  fs::path out(const std::string& name) const { return folder_ / "out" / name; }

  /// Puts a sphere of 642 vertices times four for each level above 3 there, at once.
  void put(const std::string& name, int level = 3) {
    const fs::path beside = folder_ / ("new" + fs::path(name).extension().string());
    const Status written = write_mesh(make_icosphere(level, 10), beside);
    BURNISH_CHECK(written.is_ok(), written.message());
    fs::rename(beside, in(name));
  }

  std::unique_ptr<Process> watch(const std::vector<std::string>& more) {
    std::vector<std::string> words = {BURNISH_BINARY,
                                      "watch",
                                      (folder_ / "in").string(),
                                      (folder_ / "out").string(),
                                      "--depth",
                                      "4",
                                      "--cycles",
                                      "1",
                                      "--still",
                                      "0"};
    words.insert(words.end(), more.begin(), more.end());
    return std::make_unique<Process>(words, folder_ / ("log" + std::to_string(logs_++)));
  }

  /// Waits for a result with so many vertices.
  bool comes(const std::string& name, size_t vertices) const {
    const auto end = std::chrono::steady_clock::now() + kWatchPatience;
    while (std::chrono::steady_clock::now() < end) {
      const auto mesh = read_mesh(out(name));
      if (mesh.is_ok() && mesh->vertices.size() == vertices) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  /// Returns the exit code of a run that ends by itself, and keeps its output.
  int once(std::vector<std::string> more = {}) {
    more.emplace_back("--once");
    const auto run = watch(more);
    const int code = run->wait(kWatchPatience).value_or(-1);
    output_ = run->output();
    return code;
  }

  TemporaryFolder folder_;
  std::string output_;

 private:
  int logs_ = 0;
};

TEST_F(WatchFolder, EachFileThatComesIsFilteredAndItsNextVersionToo) {
  put("early.ply");
  const auto run = watch({});
  EXPECT_TRUE(run->wait_for_output("early.ply: depth 4", kWatchPatience)) << run->output();
  put("late.ply");
  EXPECT_TRUE(run->wait_for_output("late.ply: depth 4", kWatchPatience)) << run->output();
  put("late.ply", 4);
  EXPECT_TRUE(comes("late.ply", 2562)) << run->output();
  run->signal(SIGTERM);
  EXPECT_EQ(run->wait(kWatchPatience), 128 + SIGTERM) << run->output();
}

TEST_F(WatchFolder, AScanThatIsReplacedWhileItIsFilteredIsFilteredAgain) {
  put("a.ply");
  const auto run = watch({"--to", "obj"});
  EXPECT_TRUE(run->wait_for_output("curvature", kWatchPatience)) << run->output();
  put("a.ply", 4);
  EXPECT_TRUE(comes("a.obj", 2562)) << run->output();
}

TEST_F(WatchFolder, AFileWhosePermissionsChangeIsNotFilteredAgain) {
  put("a.ply");
  const auto run = watch({});
  ASSERT_TRUE(run->wait_for_output("a.ply: depth 4", kWatchPatience)) << run->output();
  fs::permissions(in("a.ply"), fs::perms::owner_read);
  put("b.ply");  // one look sees both, in this order
  ASSERT_TRUE(run->wait_for_output("b.ply: depth 4", kWatchPatience)) << run->output();
  const std::string output = run->output();
  EXPECT_EQ(output.find("a.ply: depth 4"), output.rfind("a.ply: depth 4")) << output;
}

TEST_F(WatchFolder, AHalfWrittenFileIsFilteredOnceItIsWhole) {
  put("whole.ply");
  std::ifstream source(in("whole.ply"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(source), {}};
  const auto run = watch({});
  std::ofstream half(in("half.ply"), std::ios::binary);
  half << bytes.substr(0, bytes.size() / 2) << std::flush;
  put("another.ply");
  EXPECT_TRUE(run->wait_for_output("half.ply failed: ", kWatchPatience)) << run->output();
  half << bytes.substr(bytes.size() / 2);
  half.close();
  EXPECT_TRUE(run->wait_for_output("half.ply: depth 4", kWatchPatience)) << run->output();
  EXPECT_EQ(read_mesh(out("half.ply"))->vertices.size(), 642u);
}

TEST_F(WatchFolder, OnceItFiltersOnlyWhatIsNewAndSaysWhatFailed) {
  put("a.ply");
  put("b.obj");
  std::ofstream(in(".hidden.ply")) << "ply";
  std::ofstream(in("notes.txt")) << "of the day";
  ASSERT_EQ(once(), 0) << output_;
  EXPECT_THAT(output_, HasSubstr("a.ply: depth 4"));
  EXPECT_THAT(output_, HasSubstr("b.obj: depth 4"));
  std::ifstream report(out("a.ply.json"));
  EXPECT_EQ(nlohmann::json::parse(report)["cycles"], 1);
  ASSERT_EQ(once(), 0) << "what came in the moment of the first run may be filtered again";
  put("b.obj", 4);
  std::ofstream(in("c.ply")) << "ply";
  EXPECT_EQ(once({"--json"}), 1) << output_;
  EXPECT_EQ(output_.find("a.ply"), std::string::npos) << output_;
  EXPECT_THAT(output_, HasSubstr("\"vertices\":2562"));
  EXPECT_THAT(output_, HasSubstr("c.ply failed: "));
  std::ifstream failure(out("c.ply.json"));
  EXPECT_EQ(nlohmann::json::parse(failure)["outcome"], "failed");
}

TEST_F(WatchFolder, AResultIsTheOneOfFilter) {
  put("a.ply");
  ASSERT_EQ(once({"--beta", "0.2"}), 0) << output_;
  const std::string filtered = (folder_ / "filtered.ply").string();
  Process filter({BURNISH_BINARY, "filter", in("a.ply").string(), filtered, "--depth", "4",
                  "--cycles", "1", "--beta", "0.2"},
                 folder_ / "filter.log");
  ASSERT_EQ(filter.wait(kWatchPatience), 0) << filter.output();
  EXPECT_EQ(content_of(out("a.ply")), content_of(filtered));
}

TEST_F(WatchFolder, ASecondFileForOneResultIsRefused) {
  put("a.ply");
  put("a.obj");
  EXPECT_EQ(once({"--to", "stl"}), 1) << output_;
  EXPECT_THAT(output_, HasSubstr("a.ply failed: "));
  EXPECT_THAT(output_, HasSubstr("a.stl already; rename one"));
  EXPECT_TRUE(fs::exists(out("a.stl")));
}

TEST_F(WatchFolder, FoldersThatCannotBeWatchedAreNamed) {
  const auto result_of = [this](const std::string& from, const std::string& to) {
    Process run({BURNISH_BINARY, "watch", from, to, "--once"}, folder_ / "refused");
    EXPECT_EQ(run.wait(kWatchPatience), 1);
    return run.output();
  };
  const std::string in = (folder_ / "in").string();
  EXPECT_THAT(result_of(in, in), HasSubstr("one folder, " + in));
  EXPECT_THAT(result_of(in + "/none", in), HasSubstr("cannot watch the folder " + in + "/none"));
}

}  // namespace
}  // namespace burnish

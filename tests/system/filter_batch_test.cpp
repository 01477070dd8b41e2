// `burnish filter` on many files, on streams, and into archives.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/bundle/textured_folder.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"

namespace burnish {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class FilterBatch : public testing::Test {
 protected:
  FilterBatch() {
    for (const char* name : {"a.ply", "b.ply"})
      written_ = write_mesh(make_icosphere(3, name[0] == 'a' ? 10 : 20), path(name));
  }
  void SetUp() override { ASSERT_TRUE(written_.is_ok()) << written_.message(); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs a line of the shell in which $burnish is the program. Returns its exit code.
  int run(const std::string& line) {
    const std::string whole =
        "cd '" + folder_.path().string() + "' && burnish='" BURNISH_BINARY "' && " + line;
    Process process({"/bin/sh", "-c", whole}, path("log"));
    const int code = process.wait(std::chrono::minutes(2)).value_or(-1);
    output_ = process.output();
    return code;
  }

  json json_of(const std::string& name) const { return json::parse(content_of(path(name))); }

  TemporaryFolder folder_;
  std::string output_;

 private:
  Status written_;
};

constexpr char kQuick[] = " --depth 4 --cycles 1 ";

TEST_F(FilterBatch, EachFileIsWrittenIntoTheFolderWithItsReport) {
  ASSERT_EQ(run(std::string("$burnish filter a.ply b.ply --out-dir new/out --reports") + kQuick), 0)
      << output_;
  for (const char* name : {"a.ply", "b.ply"}) {
    const std::string out = std::string("new/out/") + name;
    EXPECT_EQ(read_mesh(path(out)).value().triangles.size(), 1280u);
    EXPECT_EQ(json_of(out + ".json")["cycles"], 1);
  }
}

TEST_F(FilterBatch, OneBadFileDoesNotEndTheOthers) {
  folder_.write("bad.ply", "plx");
  EXPECT_EQ(run(std::string("$burnish filter bad.ply a.ply absent.ply --out-dir out --json") +
                kQuick + ">facts"),
            1);
  EXPECT_THAT(output_, HasSubstr("2 of 3 files failed"));
  const json files = json_of("facts")["files"];
  std::vector<std::string> outcomes, codes;
  for (const json& file : files) {
    outcomes.push_back(file["outcome"]);
    codes.push_back(file.value("code", ""));
  }
  EXPECT_THAT(outcomes, ElementsAre("failed", "done", "failed"));
  EXPECT_THAT(codes, ElementsAre("INVALID_ARGUMENT", "", "NOT_FOUND"));
  EXPECT_THAT(std::string(files[0]["message"]), HasSubstr("plx"));
  EXPECT_EQ(files[1]["vertices"], 642);
  EXPECT_EQ(files[1]["depth"], 4);
  EXPECT_TRUE(std::filesystem::exists(path("out/a.ply")));
}

TEST_F(FilterBatch, AFileThatIsThereIsSkippedOnDemand) {
  folder_.write("mine.ply", "mine");
  ASSERT_EQ(
      run(std::string("$burnish filter a.ply mine.ply --no-clobber --json") + kQuick + ">facts"), 0)
      << output_;
  EXPECT_EQ(json_of("facts")["files"][0]["outcome"], "skipped");
  EXPECT_EQ(content_of(path("mine.ply")), "mine");
  EXPECT_EQ(run("$burnish filter a.ply mine.ply --no-clobber --force"), 2);
}

TEST_F(FilterBatch, TheFolderMayHaveAnotherFormat) {
  ASSERT_EQ(run(std::string("$burnish filter a.ply --out-dir out --to obj") + kQuick), 0)
      << output_;
  EXPECT_EQ(read_mesh(path("out/a.obj")).value().vertices.size(), 642u);
}

TEST_F(FilterBatch, TwoFilesOfOneNameAreRefusedBeforeTheWork) {
  std::filesystem::create_directory(path("other"));
  std::filesystem::copy_file(path("a.ply"), path("other/a.ply"));
  EXPECT_EQ(run("$burnish filter a.ply other/a.ply --out-dir out"), 2);
  EXPECT_THAT(output_, HasSubstr("other/a.ply"));
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

TEST_F(FilterBatch, TheInputsFolderIsNotOverwrittenWithoutForce) {
  const std::string before = content_of(path("a.ply"));
  EXPECT_EQ(run(std::string("$burnish filter a.ply --out-dir .") + kQuick), 1);
  EXPECT_THAT(output_, HasSubstr("--force"));
  EXPECT_EQ(content_of(path("a.ply")), before);
}

TEST_F(FilterBatch, StreamsGiveTheFilesBytes) {
  const std::string options = std::string(" --beta 0") + kQuick;
  ASSERT_EQ(run("$burnish filter a.ply file.ply" + options), 0) << output_;
  ASSERT_EQ(run("$burnish filter - - <a.ply 2>/dev/null >stream.ply" + options), 0) << output_;
  EXPECT_EQ(content_of(path("stream.ply")), content_of(path("file.ply")));
  ASSERT_EQ(run("$burnish filter a.ply - --to stl 2>/dev/null >stream.stl" + options), 0);
  EXPECT_EQ(read_mesh(path("stream.stl")).value().triangles.size(), 1280u);
  EXPECT_EQ(run("$burnish filter - out.ply --from obj <a.ply"), 1);
  EXPECT_EQ(run("$burnish filter - --out-dir out <a.ply"), 2);
  EXPECT_EQ(run("$burnish filter a.ply - --json"), 2);
}

TEST_F(FilterBatch, AWrongNumberOfFilesIsAUsageError) {
  EXPECT_EQ(run("$burnish filter a.ply"), 2);
  EXPECT_THAT(output_, HasSubstr("named 1 files"));
  EXPECT_EQ(run("$burnish filter a.ply b.ply c.ply"), 2);
  EXPECT_EQ(run("$burnish filter a.ply --out-dir out --report run.json"), 2);
}

TEST_F(FilterBatch, ProgressIsTellableToPrograms) {
  ASSERT_EQ(run(std::string("$burnish filter a.ply out.ply --progress json 2>steps") + kQuick), 0);
  const std::string steps = content_of(path("steps"));
  const json first = json::parse(steps.substr(0, steps.find('\n')));
  EXPECT_TRUE(first["phase"].is_string());
  EXPECT_GE(first["fraction"], 0);
  EXPECT_LE(first["fraction"], 1);
}

TEST_F(FilterBatch, AnObjIsPackedWithTheFilesThatItNames) {
  const TexturedFolder textured;
  const std::string obj = (textured / "scan.obj").string();
  ASSERT_EQ(run("$burnish filter " + obj + " out.zip" + kQuick), 0) << output_;
  EXPECT_THAT(output_, HasSubstr("gone.png"));
  ASSERT_EQ(run(std::string("mkdir back && $burnish filter out.zip back/scan.obj") + kQuick), 0)
      << output_;
  EXPECT_EQ(content_of(path("back/scan.obj")), kBundledObj);
  EXPECT_EQ(content_of(path("back/maps/skin.gif")), "skin");
  EXPECT_FALSE(std::filesystem::exists(path("back/notes.txt")));
}

TEST_F(FilterBatch, AMeshWithoutFilesBesideItIsPackedAlone) {
  ASSERT_EQ(run(std::string("$burnish filter a.ply out.zip") + kQuick), 0) << output_;
  EXPECT_EQ(read_mesh(path("out.zip")).value().triangles.size(), 1280u);
  ASSERT_EQ(run("$burnish filter a.ply moved.zip --alpha 3 --beta 0 --depth 4"), 0) << output_;
  EXPECT_LT(read_mesh(path("moved.zip")).value().vertices[0].norm(), 9);
}

TEST_F(FilterBatch, CommandsTellTheirFactsAsJson) {
  ASSERT_EQ(run("$burnish generate tablet t.ply --vertices 2000 --json >facts"), 0) << output_;
  EXPECT_EQ(json_of("facts")["vertices"], read_mesh(path("t.ply")).value().vertices.size());
  ASSERT_EQ(run("$burnish filter a.ply x.ply --depths --json >facts"), 0) << output_;
  EXPECT_EQ(json_of("facts")[0]["depth"], 4);
}

}  // namespace
}  // namespace burnish

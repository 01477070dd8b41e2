// Every format that a scan may come in to every format that it may be written in: by
// `burnish filter`, and through a server. The table is that of docs/formats.md.

#include <algorithm>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "common/archive/archive_writer.h"
#include "common/generate/generate.h"
#include "common/mesh/io/mesh_io.h"
#include "tests/common/gltf/glb_file.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A scan of a sphere: its mesh file first, then the files beside it.
struct PairSource {
  std::string stem;
  std::string extension;
  std::vector<std::pair<std::string, std::string>> files;
  bool is_packed = false;

  std::string file() const { return stem + (is_packed ? ".zip" : extension); }
};

const std::vector<std::string> kTargets = {".ply", ".obj", ".stl", ".off", ".glb", ".gltf", ".zip"};

/// Returns whether the table has a way.
bool is_written(const PairSource& source, const std::string& target) {
  return (target != ".off" && target != ".gltf") || target == source.extension;
}

std::string text_of_sphere(const std::string& extension, const std::string& stem) {
  const TriangleMesh mesh = make_icosphere(2, 1);
  const bool is_obj = extension == ".obj";
  std::string text = is_obj ? "mtllib " + stem + ".mtl\nvt 0.5 0.5\nusemtl skin\n" : "OFF\n";
  if (!is_obj)
    text +=
        std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3d& v : mesh.vertices) {
    text += is_obj ? "v" : "";
    for (const double number : v) text += " " + std::to_string(number);
    text += "\n";
  }
  for (const Triangle& triangle : mesh.triangles) {
    text += is_obj ? "f" : "3";
    for (const uint32_t v : triangle)
      text += " " + (is_obj ? std::to_string(v + 1) + "/1" : std::to_string(v));
    text += "\n";
  }
  return text;
}

/// `buffer` is the file of its data; empty: the data lies in it.
std::string gltf_of_sphere(const std::string& buffer, std::string& bin) {
  const TriangleMesh mesh = make_icosphere(2, 1);
  GlbFile file;
  std::vector<float> floats;
  std::vector<uint16_t> corners;
  for (const Vec3d& v : mesh.vertices)
    for (const double number : v) floats.push_back(static_cast<float>(number));
  for (const Triangle& t : mesh.triangles)
    for (const uint32_t v : t) corners.push_back(static_cast<uint16_t>(v));
  file.add_primitive({{"POSITION", file.add_floats("VEC3", mesh.vertices.size(), floats)}});
  file.json["meshes"][0]["primitives"][0]["indices"] = file.add_indices(corners);
  bin = file.bin;
  if (buffer.empty()) return file.gltf();
  TestJson json = file.json;
  json["buffers"] = {{{"byteLength", bin.size()}, {"uri", buffer}}};
  return json.dump();
}

/// `letter` begins the names of all files.
std::vector<PairSource> plain_sources(const std::string& letter) {
  std::vector<PairSource> sources;
  const TemporaryFolder folder;
  for (const char* extension : {".ply", ".stl", ".glb"}) {
    const auto path = folder / (std::string("mesh") + extension);
    EXPECT_TRUE(write_mesh(make_icosphere(2, 1), path).is_ok());
    const std::string stem = letter + (extension + 1);
    sources.push_back({stem, extension, {{stem + extension, content_of(path)}}});
  }
  const std::string off = letter + "off", obj = letter + "obj", gltf = letter + "gltf",
                    spread = letter + "bin";
  sources.push_back({off, ".off", {{off + ".off", text_of_sphere(".off", off)}}});
  sources.push_back({obj,
                     ".obj",
                     {{obj + ".obj", text_of_sphere(".obj", obj)},
                      {obj + ".mtl", "newmtl skin\nmap_Kd maps/" + obj + ".gif\n"},
                      {"maps/" + obj + ".gif", "a picture that is kept"}}});
  std::string bin;
  sources.push_back({gltf, ".gltf", {{gltf + ".gltf", gltf_of_sphere("", bin)}}});
  const std::string text = gltf_of_sphere(spread + ".bin", bin);
  sources.push_back({spread, ".gltf", {{spread + ".gltf", text}, {spread + ".bin", bin}}});
  return sources;
}

/// Some as they are, some packed with the mesh last.
std::vector<PairSource> all_sources() {
  std::vector<PairSource> sources = plain_sources("a");
  for (PairSource packed : plain_sources("z")) {
    packed.is_packed = true;
    std::reverse(packed.files.begin(), packed.files.end());
    sources.push_back(std::move(packed));
  }
  return sources;
}

void write_source(const PairSource& source, const std::filesystem::path& folder) {
  if (!source.is_packed) {
    for (const auto& [name, content] : source.files) {
      std::filesystem::create_directories((folder / name).parent_path());
      std::ofstream(folder / name, std::ios::binary) << content;
    }
    return;
  }
  std::vector<FileToPack> files;
  for (const auto& [name, content] : source.files)
    files.push_back({name, {reinterpret_cast<const uint8_t*>(content.data()), content.size()}});
  const auto archive = pack_archive(files);
  ASSERT_TRUE(archive.is_ok()) << archive.status().message();
  std::ofstream(folder / source.file(), std::ios::binary)
      .write(reinterpret_cast<const char*>(archive->data()),
             static_cast<std::streamsize>(archive->size()));
}

/// Checks that a file has the sphere, smaller than it was.
void expect_smoothed(const std::filesystem::path& path, const std::string& what) {
  const auto mesh = read_mesh(path);
  ASSERT_TRUE(mesh.is_ok()) << what << ": " << mesh.status().message();
  EXPECT_EQ(mesh->triangles.size(), 320u) << what;
  for (const Vec3d& vertex : mesh->vertices) ASSERT_LT(vertex.norm(), 0.9) << what;
}

/// Checks that the pictures and material files lie beside a mesh in its own format.
void expect_files_beside(const PairSource& source, const std::string& target,
                         const std::filesystem::path& folder, const std::string& what) {
  if (target != source.extension) return;
  for (const auto& [name, content] : source.files) {
    if (!name.ends_with(".mtl") && !name.ends_with(".gif")) continue;
    EXPECT_EQ(content_of(folder / name), content) << what << ": " << name;
  }
}

constexpr std::chrono::minutes kPairPatience{5};

class FilterPairs : public testing::Test {
 protected:
  /// Filters all sources to a format. Returns the outcomes by the name of their source.
  std::map<std::string, nlohmann::json> filter_to(const std::string& target) {
    const TemporaryFolder own;
    std::vector<std::string> words = {
        BURNISH_BINARY, "filter", "--json", "--depth",        "4",         "--alpha",           "3",
        "--beta",       "0",      "--to",   target.substr(1), "--out-dir", out(target).string()};
    for (const PairSource& source : sources_) words.push_back((in_ / source.file()).string());
    Process process(words, own / "log");
    EXPECT_TRUE(process.wait(kPairPatience).has_value());
    const std::string output = process.output();
    std::map<std::string, nlohmann::json> outcomes;
    const size_t begin = output.find("{\n"), end = output.rfind("\n}") + 2;  // amid the warnings
    const auto json = nlohmann::json::parse(output.substr(begin, end - begin), nullptr, false);
    EXPECT_TRUE(json.is_object()) << output;
    if (json.is_object())
      for (const auto& one : json["files"])
        outcomes[std::filesystem::path(one["in"].get<std::string>()).stem().string()] = one;
    return outcomes;
  }

  std::filesystem::path out(const std::string& target) const {
    return out_ / ("to" + target.substr(1));
  }

  const std::vector<PairSource> sources_ = all_sources();
  const TemporaryFolder in_, out_;
};

TEST_F(FilterPairs, EachIsWrittenOrRefusedInOneSentence) {
  for (const PairSource& source : sources_) write_source(source, in_.path());
  for (const std::string& target : kTargets) {
    auto outcomes = filter_to(target);
    for (const PairSource& source : sources_) {
      const std::string what = source.file() + " to " + target;
      const nlohmann::json& outcome = outcomes[source.stem];
      const auto path = out(target) / (source.stem + target);
      if (is_written(source, target)) {
        ASSERT_EQ(outcome["outcome"], "done") << what << ": " << outcome;
        expect_smoothed(path, what);
        expect_files_beside(source, target, out(target), what);
      } else {
        ASSERT_EQ(outcome["outcome"], "failed") << what;
        EXPECT_THAT(outcome["message"].get<std::string>(),
                    HasSubstr(source.extension + " file: only a scan from a " + target));
        EXPECT_FALSE(std::filesystem::exists(path)) << what;
      }
    }
  }
}

class ServerPairs : public testing::Test {
 protected:
  /// Imports a source and smooths it in a session of its name.
  void open_session(const PairSource& source) {
    write_source(source, in_.path());
    const std::string file = (in_ / source.file()).string();
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"import", file, "--depth", "4"},
          {"open", source.stem, "--depth", "4", "--session", "s" + source.stem},
          {"edit", "s" + source.stem, "--alpha", "3", "--beta", "0"}}) {
      const CommandOutcome done = server_.burnish(words);
      ASSERT_EQ(done.exit_code, 0) << source.file() << ": " << done.output;
    }
  }

  const TemporaryFolder in_, out_;
  ServerProcess server_;
};

TEST_F(ServerPairs, EachIsWrittenOrRefusedInOneSentence) {
  for (const PairSource& source : all_sources()) {
    open_session(source);
    const auto folder = out_ / source.stem;
    std::filesystem::create_directory(folder);
    for (const std::string& target : kTargets) {
      const std::string what = source.file() + " to " + target;
      const auto path = folder / (source.stem + target);
      const CommandOutcome done = server_.burnish({"export", "s" + source.stem, path.string()});
      if (is_written(source, target)) {
        ASSERT_EQ(done.exit_code, 0) << what << ": " << done.output;
        expect_smoothed(path, what);
        expect_files_beside(source, target, folder, what);
      } else {
        EXPECT_EQ(done.exit_code, 1) << what;
        EXPECT_THAT(done.output,
                    HasSubstr(source.extension + " file: only a scan from a " + target));
        EXPECT_FALSE(std::filesystem::exists(path)) << what;
      }
    }
  }
}

/// A .gltf with its data beside it, and `burnish filter`.
class SpreadGltf : public testing::Test {
 protected:
  SpreadGltf() {
    for (const PairSource& source : plain_sources("a"))
      if (source.stem == "abin") write_source(source, folder_.path());
    std::filesystem::create_directory(folder_ / "other");
  }
  int filter(std::vector<std::string> words) {
    words.insert(words.begin(), {BURNISH_BINARY, "filter", (folder_ / "abin.gltf").string()});
    for (const char* word : {"--depth", "4", "--alpha", "3", "--beta", "0"})
      words.emplace_back(word);
    Process process(words, folder_ / "log");
    const int code = process.wait(kPairPatience).value_or(-1);
    output_ = process.output();
    return code;
  }
  const TemporaryFolder folder_;
  std::string output_;
};

TEST_F(SpreadGltf, GoesIntoAnotherFolderWithItsData) {
  ASSERT_EQ(filter({(folder_ / "other/o.gltf").string()}), 0) << output_;
  expect_smoothed(folder_ / "other/o.gltf", "o.gltf");
  EXPECT_NE(content_of(folder_ / "other/abin.bin"), content_of(folder_ / "abin.bin"));
}

TEST_F(SpreadGltf, DoesNotReplaceDataUnasked) {
  const std::string data = content_of(folder_ / "abin.bin");
  EXPECT_EQ(filter({(folder_ / "o.gltf").string()}), 1);
  EXPECT_THAT(output_, HasSubstr((folder_ / "abin.bin").string() + " is there"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "o.gltf"));
  EXPECT_EQ(content_of(folder_ / "abin.bin"), data);
  EXPECT_EQ(filter({(folder_ / "o.gltf").string(), "--force"}), 0) << output_;
  expect_smoothed(folder_ / "o.gltf", "o.gltf");
}

TEST_F(SpreadGltf, IsNotForAStream) {
  EXPECT_EQ(filter({"-"}), 1);
  EXPECT_THAT(output_, HasSubstr("'abin.bin'"));
  EXPECT_EQ(filter({"-", "--to", "glb"}), 0) << output_;
}

}  // namespace
}  // namespace burnish

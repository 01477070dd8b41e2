// Reading, rewriting and writing a file of any format hears a cancel often.

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/archive/archive.h"
#include "common/archive/archive_writer.h"
#include "common/generate/generate.h"
#include "common/gltf/base64.h"
#include "common/mesh/io/mesh_io.h"
#include "common/mesh/rewrite/rewrite.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

/// Counts the questions, and refuses from number `until` on.
class CountingBudget {
 public:
  explicit CountingBudget(size_t until = SIZE_MAX) : until_(until) {}

  FileBudget budget() {
    return [this](uint64_t) {
      return ++asked_ < until_ ? Status::ok() : cancelled("somebody cancels");
    };
  }
  size_t asked() const { return asked_; }

 private:
  const size_t until_;
  size_t asked_ = 0;
};

std::string text_of(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
std::span<const uint8_t> bytes_in(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::string written(const TriangleMesh& mesh, const std::string& name) {
  const TemporaryFolder folder;
  EXPECT_TRUE(write_mesh(mesh, folder / name).is_ok());
  return content_of(folder / name);
}

/// Vertices and faces as lines, each behind a word.
std::string lines_of(const TriangleMesh& mesh, const std::string& vertex, const std::string& face,
                     uint32_t first) {
  std::ostringstream text;
  for (const Vec3d& v : mesh.vertices)
    text << vertex << float(v.x()) << ' ' << float(v.y()) << ' ' << float(v.z()) << '\n';
  for (const Triangle& t : mesh.triangles)
    text << face << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first << '\n';
  return text.str();
}

std::string ply_text(const TriangleMesh& mesh) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n" + lines_of(mesh, "", "3 ", 0);
}

std::string off_text(const TriangleMesh& mesh) {
  return "OFF\n" + std::to_string(mesh.vertices.size()) + " " +
         std::to_string(mesh.triangles.size()) + " 0\n" + lines_of(mesh, "", "3 ", 0);
}

std::string stl_text(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "solid s\n";
  for (const Triangle& t : mesh.triangles) {
    text << "facet normal 0 0 1\nouter loop\n";
    for (const uint32_t v : t)
      text << "vertex " << float(mesh.vertices[v].x()) << ' ' << float(mesh.vertices[v].y()) << ' '
           << float(mesh.vertices[v].z()) << '\n';
    text << "endloop\nendfacet\n";
  }
  text << "endsolid s\n";
  return text.str();
}

/// A soup whose positions are in the text.
std::string gltf_text(const TriangleMesh& mesh) {
  std::vector<Vec3f> corners;
  for (const Triangle& t : mesh.triangles)
    for (const uint32_t v : t) corners.push_back(mesh.vertices[v].cast<float>());
  const std::string bytes = std::to_string(corners.size() * sizeof(Vec3f));
  return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"buffers":[{"byteLength":)" + bytes +
         R"(,"uri":"data:;base64,)" +
         to_base64(
             {reinterpret_cast<const uint8_t*>(corners.data()), corners.size() * sizeof(Vec3f)}) +
         R"("}],"bufferViews":[{"buffer":0,"byteLength":)" + bytes +
         R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
         std::to_string(corners.size()) +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})";
}

std::string zip_of(const std::string& name, const std::string& content) {
  const FileToPack file = {name, bytes_in(content)};
  return text_of(pack_archive({&file, 1}).value());
}

struct HeardFile {
  std::string name;
  MeshFormat format;
  std::string (*make)(const TriangleMesh& mesh);
};

const TriangleMesh& sphere() {
  static const TriangleMesh mesh = make_icosphere(5, 1);
  return mesh;
}

const HeardFile kFiles[] = {
    {"BinaryPly", MeshFormat::kPly, [](const TriangleMesh& m) { return written(m, "a.ply"); }},
    {"TextPly", MeshFormat::kPly, ply_text},
    {"Obj", MeshFormat::kObj, [](const TriangleMesh& m) { return written(m, "a.obj"); }},
    {"BinaryStl", MeshFormat::kStl, [](const TriangleMesh& m) { return written(m, "a.stl"); }},
    {"TextStl", MeshFormat::kStl, stl_text},
    {"Off", MeshFormat::kOff, off_text},
    {"Glb", MeshFormat::kGlb, [](const TriangleMesh& m) { return written(m, "a.glb"); }},
    {"Gltf", MeshFormat::kGltf, gltf_text},
    {"Zip", MeshFormat::kZip,
     [](const TriangleMesh& m) { return zip_of("a.obj", written(m, "a.obj")); }},
};

class HeardFiles : public testing::TestWithParam<HeardFile> {
 protected:
  Status read(CountingBudget& counting) const {
    return read_stored_mesh(bytes_in(content_), GetParam().format, "scan", {}, counting.budget())
        .status();
  }

  /// Every triangle and vertex is a step at least.
  static size_t fewest_questions() {
    return (sphere().triangles.size() + sphere().vertices.size()) / kHeardBlock;
  }

  /// Cancels some work at a question early, in the middle and late.
  template <typename Work>
  static void expect_cancels(const Work& work) {
    CountingBudget all;
    const Status whole = work(all);
    EXPECT_TRUE(whole.is_ok()) << whole.message();
    EXPECT_GE(all.asked(), fewest_questions());
    for (const size_t until : {size_t{1}, all.asked() / 2, all.asked()}) {
      CountingBudget some(until);
      EXPECT_EQ(work(some).code(), StatusCode::kCancelled) << until << " of " << all.asked();
      EXPECT_LE(some.asked(), until + 1) << "a refusal ends the work";
    }
  }

  const std::string content_ = GetParam().make(sphere());
};

INSTANTIATE_TEST_SUITE_P(Formats, HeardFiles, testing::ValuesIn(kFiles),
                         [](const auto& file) { return file.param.name; });

TEST_P(HeardFiles, AreCancelledAnywhereWhileTheyAreRead) {
  expect_cancels([&](CountingBudget& counting) { return read(counting); });
}

TEST_P(HeardFiles, AreCancelledAnywhereWhileTheyAreWrittenAgain) {
  const TemporaryFolder folder;
  const std::string extension = extension_of(GetParam().format);
  const OriginalFile original = {folder.write("scan" + extension, content_), GetParam().format,
                                 "scan"};
  TriangleMesh after = read_mesh(original.path).value();
  const std::vector<Vec3d> before = after.vertices;
  for (Vec3d& vertex : after.vertices) vertex *= 2;
  const auto path = folder / ("moved" + extension);
  expect_cancels([&](CountingBudget& counting) {
    return write_moved_mesh(original, {before, after}, path, nullptr, counting.budget());
  });
}

TEST(HeardArchives, AreCancelledWhileTheyAreUnpackedAndPacked) {
  constexpr size_t kMegabytes = 8;
  std::string noise(kMegabytes << 20, '\0');
  uint32_t state = 1;
  for (char& c : noise) c = static_cast<char>((state = state * 1664525 + 1013904223) >> 24);
  const FileToPack file = {"noise.txt", bytes_in(noise)};
  CountingBudget packing;
  const auto packed = pack_archive({&file, 1}, packing.budget());
  ASSERT_TRUE(packed.is_ok()) << packed.status().message();
  EXPECT_GE(packing.asked(), kMegabytes);
  CountingBudget at_third(3);
  EXPECT_EQ(pack_archive({&file, 1}, at_third.budget()).status().code(), StatusCode::kCancelled);

  const Archive archive = std::move(Archive::open(*packed, "a.zip")).value();
  CountingBudget unpacking, at_second(2);
  EXPECT_TRUE(archive.read(0, unpacking.budget()).is_ok());
  EXPECT_GE(unpacking.asked(), kMegabytes);
  EXPECT_EQ(archive.read(0, at_second.budget()).status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace burnish

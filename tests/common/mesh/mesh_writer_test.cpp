#include <cmath>

#include "common/mesh/io/mesh_io.h"
#include "tests/common/base/file_size_limit.h"
#include "tests/common/mesh/reading.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Returns a wavy sheet of side² vertices whose coordinates need all digits of a float.
TriangleMesh wavy_sheet(uint32_t side) {
  TriangleMesh mesh;
  for (uint32_t i = 0; i < side; ++i)
    for (uint32_t j = 0; j < side; ++j)
      mesh.vertices.push_back(
          Vec3f(static_cast<float>(i) / 7, static_cast<float>(j) / 3, std::sin(0.1F * i) * 1e-3F)
              .cast<double>());
  for (uint32_t i = 0; i + 1 < side; ++i) {
    for (uint32_t j = 0; j + 1 < side; ++j) {
      const uint32_t a = i * side + j;
      mesh.triangles.push_back({a, a + side, a + side + 1});
      mesh.triangles.push_back({a, a + side + 1, a + 1});
    }
  }
  return mesh;
}

void add_colours(TriangleMesh& mesh, uint8_t alpha) {
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    mesh.colours.push_back(
        {static_cast<uint8_t>(v), static_cast<uint8_t>(255 - v % 256), 7, alpha});
}

TriangleMesh round_trip(const TriangleMesh& mesh, const std::string& name) {
  TemporaryFolder folder;
  const Status written = write_mesh(mesh, folder / name);
  EXPECT_TRUE(written.is_ok()) << written.message();
  EXPECT_EQ(folder.file_count(), 1u);
  Result<TriangleMesh> read = read_mesh(folder / name);
  EXPECT_TRUE(read.is_ok()) << read.status().message();
  return read.is_ok() ? std::move(read).value() : TriangleMesh();
}

/// Rounds positions from a reader as the writer does.
std::vector<Vec3f> as_floats(const std::vector<Vec3d>& positions) {
  std::vector<Vec3f> floats;
  for (const Vec3d& position : positions) floats.push_back(position.cast<float>());
  return floats;
}

TEST(MeshWriter, PlyObjAndGlbReadBackTheSameFloats) {
  for (const char* name : {"a.ply", "a.obj", "a.PLY", "a.glb"}) {
    TriangleMesh mesh = wavy_sheet(40);
    for (const bool with_colours : {false, true}) {
      if (with_colours) add_colours(mesh, 255);
      const TriangleMesh read = round_trip(mesh, name);
      EXPECT_EQ(as_floats(read.vertices), as_floats(mesh.vertices)) << name;
      EXPECT_EQ(read.triangles, mesh.triangles) << name;
      EXPECT_EQ(read.colours, mesh.colours) << name;
      EXPECT_FALSE(read.has_double_positions) << name;
    }
  }
}

TEST(MeshWriter, DoublePositionsReadBackExactly) {
  TriangleMesh mesh = wavy_sheet(10);
  for (Vec3d& position : mesh.vertices) position += Vec3d(512345.678, 1.0 / 3, 1e-9);
  mesh.has_double_positions = true;
  for (const char* name : {"a.ply", "a.obj"}) {
    const TriangleMesh read = round_trip(mesh, name);
    EXPECT_EQ(read.vertices, mesh.vertices) << name;
    EXPECT_TRUE(read.has_double_positions) << name;
  }
}

TEST(MeshWriter, AGlbFarFromTheOriginIsWrittenAroundItsOwnPlace) {
  TriangleMesh mesh = wavy_sheet(10);
  for (Vec3d& position : mesh.vertices) position += Vec3d(4512345.678, 1.0 / 3, 1e-9);
  mesh.has_double_positions = true;
  const TriangleMesh read = round_trip(mesh, "a.glb");
  ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    EXPECT_LT((read.vertices[v] - mesh.vertices[v]).norm(), 1e-6);
}

TEST(MeshWriter, PlyAndGlbKeepAlpha) {
  TriangleMesh mesh = wavy_sheet(3);
  add_colours(mesh, 99);
  for (const char* name : {"a.ply", "a.glb"})
    EXPECT_EQ(round_trip(mesh, name).colours, mesh.colours);
}

TEST(MeshWriter, EverySrgbByteComesBackFromAGlb) {
  TriangleMesh mesh = wavy_sheet(16);
  for (size_t v = 0; v < 256; ++v)
    mesh.colours.push_back({static_cast<uint8_t>(v), static_cast<uint8_t>(255 - v), 0, 255});
  EXPECT_EQ(round_trip(mesh, "a.glb").colours, mesh.colours);
}

TEST(MeshWriter, StlReadsBackTheSameTriangles) {
  const TriangleMesh mesh = wavy_sheet(40);
  const TriangleMesh read = round_trip(mesh, "a.stl");
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(read.vertices.size(), mesh.vertices.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      ASSERT_EQ(read.vertices[read.triangles[t][corner]], mesh.vertices[mesh.triangles[t][corner]]);
}

TEST(MeshWriter, StlNormalsHaveLengthOneOrZero) {
  TriangleMesh mesh;
  mesh.vertices = {Vec3d(0, 0, 0), Vec3d(1e-12, 0, 0), Vec3d(0, 1e-12, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 1, 1}};
  TemporaryFolder folder;
  ASSERT_TRUE(write_mesh(mesh, folder / "a.stl").is_ok());
  const std::string content = content_of(folder / "a.stl");
  ASSERT_EQ(content.size(), 84u + 2 * 50u);
  EXPECT_EQ(content.substr(84, 12), bytes_of(0.F, 0.F, 1.F));
  EXPECT_EQ(content.substr(134, 12), bytes_of(0.F, 0.F, 0.F));
}

TEST(MeshWriter, ObjNumbersAreTheShortestThatReadBack) {
  TriangleMesh mesh;
  mesh.vertices = {Vec3d(0.1F, 0, -2), Vec3d(1, 0, 0), Vec3d(0, 1e-7F, 0)};
  mesh.triangles = {{0, 1, 2}};
  TemporaryFolder folder;
  ASSERT_TRUE(write_mesh(mesh, folder / "a.obj").is_ok());
  EXPECT_EQ(content_of(folder / "a.obj"), "v 0.1 0 -2\nv 1 0 0\nv 0 1e-07 0\nf 1 2 3\n");
}

TEST(MeshWriter, RefusesOffOtherExtensionsAndBadMeshes) {
  TemporaryFolder folder;
  EXPECT_THAT(write_mesh(wavy_sheet(3), folder / "a.off").message(), HasSubstr("a .off file"));
  EXPECT_THAT(write_mesh(wavy_sheet(3), folder / "a.txt").message(),
              HasSubstr("'.txt' is not a mesh format"));
  EXPECT_THAT(write_mesh(wavy_sheet(3), folder / "a.xyz").message(),
              testing::Not(HasSubstr(".off")));
  TriangleMesh mesh = wavy_sheet(3);
  mesh.vertices[4][1] = NAN;
  EXPECT_THAT(write_mesh(mesh, folder / "a.ply").message(), HasSubstr("vertex 4 has y = nan"));
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(MeshWriter, AMissingFolderOrADirectoryAsTargetIsRefused) {
  TemporaryFolder folder;
  fs::create_directory(folder / "folder.ply");
  EXPECT_EQ(write_mesh(wavy_sheet(3), folder / "absent/a.ply").code(), StatusCode::kNotFound);
  EXPECT_THAT(write_mesh(wavy_sheet(3), folder / "folder.ply").message(),
              HasSubstr("it is a directory"));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(MeshWriter, AFullDiskLeavesTheOldFile) {
  TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj", "a.stl", "a.glb"}) {
    folder.write(name, "old");
    const FileSizeLimit limit(10'000);
    const Status status = write_mesh(wavy_sheet(200), folder / name);
    EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
    EXPECT_THAT(status.message(), HasSubstr(name));
    EXPECT_EQ(content_of(folder / name), "old");
  }
  EXPECT_EQ(folder.file_count(), 4u);
}

}  // namespace
}  // namespace burnish

#include "common/mesh/io/mesh_io.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/mesh/export_formats.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

TEST(MeshIo, KnowsFormatsByExtensionInAnyCase) {
  EXPECT_EQ(*mesh_format_of_path("a.ply"), MeshFormat::kPly);
  EXPECT_EQ(*mesh_format_of_path("b/a.x.OBJ"), MeshFormat::kObj);
  EXPECT_EQ(*mesh_format_of_path("a.Stl"), MeshFormat::kStl);
  EXPECT_EQ(*mesh_format_of_path("a.off"), MeshFormat::kOff);
  EXPECT_EQ(*mesh_format_of_path("a.GLB"), MeshFormat::kGlb);
  EXPECT_EQ(*mesh_format_of_path("a.gltf"), MeshFormat::kGltf);
  EXPECT_EQ(*mesh_format_of_path("a.obj.zip"), MeshFormat::kZip);
}

TEST(MeshIo, RefusesOtherExtensionsWithTheChoices) {
  for (const char* path : {"scan.xyz", "ply", "folder.ply/scan"}) {
    const auto format = mesh_format_of_path(path);
    ASSERT_FALSE(format.is_ok());
    EXPECT_THAT(format.status().message(), AllOf(HasSubstr(path), HasSubstr(".ply, .obj, .stl")));
  }
}

TEST(MeshIo, ExportFormatsBeginWithThatOfTheScanIfItIsWritten) {
  using enum MeshFormat;
  EXPECT_THAT(export_formats(kStl), testing::ElementsAre(kStl, kPly, kObj, kGlb));
  EXPECT_THAT(export_formats(kZip), testing::ElementsAre(kZip, kPly, kObj, kStl, kGlb));
  EXPECT_THAT(export_formats(kOff), testing::ElementsAre(kPly, kObj, kStl, kGlb));
}

TEST(MeshIo, ReadsFilesAndNamesThemInMessages) {
  TemporaryFolder folder;
  const auto good = folder.write("good.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto mesh = read_mesh(good);
  ASSERT_TRUE(mesh.is_ok()) << mesh.status().message();
  EXPECT_EQ(mesh->triangles.size(), 1u);
  const auto bad = folder.write("bad.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_THAT(read_mesh(bad).status().message(), HasSubstr(bad.string() + ": line 1: vertex 0"));
}

TEST(MeshIo, AMeshInScratchFilesIsTheMeshInMemory) {
  TemporaryFolder folder;
  const ScratchSpace space(folder / "", 0);
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
      "property double y\nproperty double z\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n";
  const std::string ply = header +
                          "0 0 0 1 2 3\n1 0 0 4 5 6\n1 1 0.1 7 8 9\n0 1 0 0 0 0\n"
                          "4 0 1 2 3\n3 0 2 1\n";
  const std::string obj = "v 0 0 0\nv 1 0 0 1 0 0.5\nv 0 1.0000000001 0\nf 1 2 3\nf -1 -2 -3 1\n";
  const std::string off = "COFF\n3 1 0\n0 0 0 9 8 7\n1 0 0 6 5 4\n0 1 0 3 2 1\n3 0 1 2\n";
  std::string stl = "solid\n";
  for (const char* third : {"0 1 0", "0 0 -1", "-0 1 0"})
    stl += std::string("facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex ") +
           third + "\nendloop\nendfacet\n";
  stl += "endsolid\n";
  for (const auto& [text, format] :
       {std::pair(ply, MeshFormat::kPly), std::pair(obj, MeshFormat::kObj),
        std::pair(off, MeshFormat::kOff), std::pair(stl, MeshFormat::kStl)}) {
    EXPECT_TRUE(is_read_into_scratch(format));
    const std::span bytes(reinterpret_cast<const uint8_t*>(text.data()), text.size());
    const TriangleMesh mesh = read_mesh(bytes, format, "scan").value();
    const StoredMesh stored = read_stored_mesh(bytes, format, "scan", space).value();
    EXPECT_EQ(space.memory_bytes(), 0u);
    EXPECT_TRUE(std::ranges::equal(stored.vertices, mesh.vertices));
    EXPECT_TRUE(std::ranges::equal(stored.triangles, mesh.triangles));
    EXPECT_TRUE(std::ranges::equal(stored.colours, mesh.colours));
    EXPECT_EQ(stored.has_double_positions, mesh.has_double_positions);
  }
}

TEST(MeshIo, AMeshInScratchFilesIsCheckedAsOneInMemory) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n";
  const std::span bytes(reinterpret_cast<const uint8_t*>(ply.data()), ply.size());
  const auto stored = read_stored_mesh(bytes, MeshFormat::kPly, "scan.ply", {});
  EXPECT_EQ(stored.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(stored.status().message(), AllOf(HasSubstr("scan.ply"), HasSubstr("no area")));
}

TEST(MeshIo, AMissingFileIsNotFound) {
  TemporaryFolder folder;
  const Status status = read_mesh(folder / "absent.stl").status();
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_THAT(status.message(), HasSubstr("absent.stl: No such file"));
}

TEST(MeshIo, RefusesADirectoryNamedLikeAMesh) {
  TemporaryFolder folder;
  fs::create_directory(folder / "folder.ply");
  const Status status = read_mesh(folder / "folder.ply").status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("folder.ply: it is a directory"));
}

TEST(MeshIo, RefusesAnEmptyFile) {
  TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj", "a.stl", "a.off"}) {
    const Status status = read_mesh(folder.write(name, "")).status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
    EXPECT_THAT(status.message(), HasSubstr(std::string(name) + ": the file is empty (0 bytes)"));
  }
}

}  // namespace
}  // namespace burnish

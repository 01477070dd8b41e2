#include "common/mesh/mesh_io.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(MeshIo, ReadsFilesAndNamesThemInMessages) {
  TemporaryFolder folder;
  const auto good = folder.write("good.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto mesh = read_mesh(good);
  ASSERT_TRUE(mesh.is_ok()) << mesh.status().message();
  EXPECT_EQ(mesh->triangles.size(), 1u);
  const auto bad = folder.write("bad.obj", "v 0 0 nan\n");
  EXPECT_THAT(read_mesh(bad).status().message(), HasSubstr(bad.string() + ": line 1: vertex 0"));
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

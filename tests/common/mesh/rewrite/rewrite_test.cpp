#include "common/mesh/rewrite/rewrite.h"

#include "tests/common/base/file_size_limit.h"
#include "tests/common/mesh/rewrite/rewriting.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

const std::string kTriangle = "# mine\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class RewriteMesh : public testing::Test {
 protected:
  RewriteMesh() : mesh_(parsed(MeshFormat::kObj, kTriangle)), before_(mesh_.vertices) {}

  Status write(const std::string& name) {
    return write_moved_mesh({folder_.write("in.obj", content_), MeshFormat::kObj, "in"},
                            {before_, mesh_}, folder_ / name);
  }

  TemporaryFolder folder_;
  std::string content_ = kTriangle;
  TriangleMesh mesh_;
  std::vector<Vec3d> before_;
};

TEST_F(RewriteMesh, TheOriginalsFormatKeepsTheFileAndOthersAreWrittenAnew) {
  mesh_.vertices[1][0] = 2;
  ASSERT_TRUE(write("out.obj").is_ok());
  EXPECT_EQ(content_of(folder_ / "out.obj"), replaced(kTriangle, "v 1 0 0", "v 2 0 0"));
  ASSERT_TRUE(write("out.ply").is_ok());
  EXPECT_THAT(content_of(folder_ / "out.ply"), testing::StartsWith("ply\n"));
}

TEST_F(RewriteMesh, AFileMayBeWrittenInItsOwnPlace) {
  mesh_.vertices[1][0] = 2;
  ASSERT_TRUE(write("in.obj").is_ok());
  EXPECT_EQ(content_of(folder_ / "in.obj"), replaced(kTriangle, "v 1 0 0", "v 2 0 0"));
}

TEST_F(RewriteMesh, AChangedOriginalIsRefusedByItsVertex) {
  content_ = replaced(kTriangle, "v 0 1 0", "v 0 3 0");
  const Status changed = write("out.obj");
  EXPECT_EQ(changed.code(), StatusCode::kDataLoss);
  EXPECT_THAT(changed.message(), HasSubstr("vertex 2 has y = 3, it had 1"));
  content_ = kTriangle + "v 9 9 9\n";
  EXPECT_EQ(write("out.obj").code(), StatusCode::kDataLoss);
  content_ = "v 0 0 0\n";
  EXPECT_THAT(write("out.obj").message(), HasSubstr("1 vertices, it had 3"));
  EXPECT_EQ(folder_.file_count(), 1u);
}

TEST_F(RewriteMesh, AChangedOriginalOfAnyFormatIsRefused) {
  const std::pair<MeshFormat, std::string> files[] = {
      {MeshFormat::kPly,
       "ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\n"
       "property int y\nproperty int z\nelement face 1\n"
       "property list int int vertex_index\nend_header\n"},
      {MeshFormat::kStl, "solid\nendsolid\n"},
      {MeshFormat::kStl, "too short"},
      {MeshFormat::kOff, "COFF\n0 0 0\n"},
      {MeshFormat::kOff, "HOFF\n"}};
  for (const auto& [format, content] : files) {
    OutputBuffer output([](std::string_view) { return Status::ok(); });
    const Status status =
        rewrite_mesh({reinterpret_cast<const uint8_t*>(content.data()), content.size()}, format,
                     "in", {before_, mesh_}, output);
    EXPECT_FALSE(status.is_ok()) << content;
  }
}

TEST_F(RewriteMesh, AFullDiskLeavesTheOldFile) {
  content_ += std::string(100'000, '#') + "\n";
  folder_.write("out.obj", "old");
  folder_.write("in.obj", content_);
  const FileSizeLimit limit(10'000);
  EXPECT_EQ(write_moved_mesh({folder_ / "in.obj", MeshFormat::kObj, "in"}, {before_, mesh_},
                             folder_ / "out.obj")
                .code(),
            StatusCode::kResourceExhausted);
  EXPECT_EQ(content_of(folder_ / "out.obj"), "old");
}

TEST_F(RewriteMesh, BytesBeyondABufferAreCopied) {
  content_ += "# " + std::string(900'000, 'a') + "\n# " + std::string(900'000, 'b') + "\n";
  ASSERT_TRUE(write("out.obj").is_ok());
  EXPECT_EQ(content_of(folder_ / "out.obj"), content_);
}

}  // namespace
}  // namespace burnish

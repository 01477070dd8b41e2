#include <gmock/gmock.h>

#include "common/archive/archive.h"
#include "common/mesh/rewrite/left_out/left_out.h"
#include "tests/common/archive/packing.h"
#include "tests/common/mesh/rewrite/rewriting.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;

const std::string kObj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

NamedTexts scan_files() {
  return {{"a.mtl", "newmtl a\nmap_Kd none.png\n"}, {"scan.obj", kObj}, {"b.png", "pixels"}};
}

Vec3d shifted(size_t, const Vec3d& position) {
  return position + Vec3d(0, 0, 2);
}

TEST(ZipRewriter, AMeshThatDidNotMoveGivesTheSameArchive) {
  const std::string archive = as_string(packed(scan_files()));
  EXPECT_EQ(rewritten(MeshFormat::kZip, archive), archive);
}

TEST(ZipRewriter, AMovedMeshIsTheOnlyEntryThatChanges) {
  const std::string moved = rewritten(MeshFormat::kZip, as_string(packed(scan_files())), shifted);
  const Archive archive = std::move(Archive::open(as_bytes(moved), "moved")).value();
  ASSERT_EQ(archive.entries().size(), 3u);
  for (size_t e = 0; e < 3; ++e) {
    const auto [name, content] = scan_files()[e];
    EXPECT_EQ(archive.entries()[e].name, name);
    const std::string expected = e == 1 ? rewritten(MeshFormat::kObj, content, shifted) : content;
    EXPECT_EQ(as_string(archive.read(e).value()), expected);
  }
}

/// An archive on disk, and the same mesh moved.
class PackedScan : public testing::Test {
 protected:
  PackedScan() {
    after_ = parsed(MeshFormat::kZip, content_);
    before_ = after_.vertices;
    for (Vec3d& vertex : after_.vertices) vertex = shifted(0, vertex);
  }

  std::string written(const std::string& name) {
    EXPECT_TRUE(write_moved_mesh(original_, {before_, after_}, folder_ / name).is_ok());
    return content_of(folder_ / name);
  }

  std::vector<std::string> left_out(MeshFormat to) {
    return attributes_left_out(original_, to, after_).value();
  }

  const TemporaryFolder folder_;
  const std::string content_ = as_string(packed(scan_files()));
  const OriginalFile original_ = {folder_.write("in.zip", content_), MeshFormat::kZip, "in"};
  TriangleMesh after_;
  std::vector<Vec3d> before_;
};

TEST_F(PackedScan, TheMeshsOwnFormatGivesTheMeshRewritten) {
  EXPECT_EQ(written("out.obj"), rewritten(MeshFormat::kObj, kObj, shifted));
  EXPECT_THAT(left_out(MeshFormat::kObj), ElementsAre("material files", "pictures"));
}

TEST_F(PackedScan, AnotherFormatNamesTheFilesAndTheAttributes) {
  EXPECT_EQ(parsed(MeshFormat::kPly, written("out.ply")).vertices[0].z(), 2);
  EXPECT_THAT(left_out(MeshFormat::kPly),
              ElementsAre("material files", "pictures", "materials", "texture coordinates"));
}

TEST_F(PackedScan, TheArchiveItselfLeavesNothingOut) {
  EXPECT_EQ(written("out.zip"), rewritten(MeshFormat::kZip, content_, shifted));
  EXPECT_TRUE(left_out(MeshFormat::kZip).empty());
}

}  // namespace
}  // namespace burnish

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/archive/archive.h"
#include "common/generate/generate.h"
#include "common/picture/picture.h"
#include "server/journal/sqlite_journal.h"
#include "server/manager/session_manager.h"
#include "tests/common/archive/packing.h"
#include "tests/common/mesh/rewrite/photo_grid.h"
#include "tests/common/mesh/rewrite/textured_grid.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A sphere as other programs write it: with texture coordinates, a material and a comment.
std::string textured_sphere() {
  const TriangleMesh sphere = make_icosphere(3, 1);
  std::string text = "# made elsewhere\r\nmtllib stone.mtl\r\n";
  for (const Vec3d& p : sphere.vertices) {
    text += "v ";
    for (const double x : p) text += std::to_string(x) + " ";
    text += "\r\n";
  }
  text += "vt 0.5 0.5\r\nusemtl stone\r\n";
  for (const Triangle& triangle : sphere.triangles) {
    text += "f";
    for (const uint32_t v : triangle) text += " " + std::to_string(v + 1) + "/1";
    text += "\r\n";
  }
  return text;
}

/// A sphere with colours at its vertices.
std::string coloured_sphere() {
  const TriangleMesh sphere = make_icosphere(3, 1);
  std::string text;
  for (const Vec3d& p : sphere.vertices) {
    text += "v";
    for (const double x : p) text += " " + std::to_string(x);
    for (const double x : p) text += " " + std::to_string(0.5 + 0.4 * x);
    text += "\n";
  }
  for (const Triangle& triangle : sphere.triangles) {
    text += "f";
    for (const uint32_t v : triangle) text += " " + std::to_string(v + 1);
    text += "\n";
  }
  return text;
}

class SessionExport : public testing::Test {
 protected:
  SessionExport() {
    scan_id_ = library_.import(file_, "ball", {}, 5, MeshFormat::kObj).value().scan.id;
    journal_ = std::move(SqliteJournal::open(library_.folder->journal())).value();
    SessionManagerOptions options;
    options.solver.threads = 1;
    manager_ =
        std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
            .value();
    EXPECT_TRUE(manager_->open({"ball", "one", {5, 0}}, {}, {}).is_ok());
  }

  Result<std::unique_ptr<ExportFile>> exported(MeshFormat format) {
    return manager_->export_mesh("one", {format, false, 1}, {});
  }

  const std::string file_ = textured_sphere();
  TestLibrary library_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
  std::string scan_id_;
};

TEST_F(SessionExport, AnUneditedScanComesBackByteForByte) {
  const auto file = exported(MeshFormat::kObj);
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  EXPECT_EQ(file.value()->read(0).value(), file_);
  EXPECT_EQ(file.value()->summary().sha256, scan_id_);
  EXPECT_THAT(file.value()->summary().left_out, IsEmpty());
}

TEST_F(SessionExport, AnEditedScanKeepsAllButItsPositions) {
  const std::vector<Edit> edits = {{"a", SetGradientScale{0}}};
  ASSERT_TRUE(manager_->apply("one", {}, edits, {}).is_ok());
  const std::string text = exported(MeshFormat::kObj).value()->read(0).value();
  EXPECT_NE(text, file_);
  EXPECT_EQ(text.substr(text.find("vt 0.5")), file_.substr(file_.find("vt 0.5")));
}

TEST_F(SessionExport, AnotherFormatNamesWhatItLeavesOut) {
  const auto file = exported(MeshFormat::kPly);
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  EXPECT_THAT(file.value()->summary().left_out,
              ElementsAre("materials", "texture coordinates", "comments"));
}

/// A fan of two triangles.
constexpr char kTile[] = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 6}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}],
  "bufferViews": [{"buffer": 0, "byteLength": 48}], "materials": [{"name": "clay"}],
  "buffers": [{"byteLength": 48, "uri": "data:;base64,)"
                         R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAIA+AAAAAAAAgD8AAAAA"}]})";

TEST_F(SessionExport, AGltfComesBackByteForByteAndNamesItsMaterialsForAPly) {
  ASSERT_TRUE(library_.import(kTile, "tile", {}, 5, MeshFormat::kGltf).is_ok());
  ASSERT_TRUE(manager_->open({"tile", "two", {5, 0}}, {}, {}).is_ok());
  const auto file = manager_->export_mesh("two", {MeshFormat::kGltf, false, 1}, {});
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  EXPECT_EQ(file.value()->read(0).value(), kTile);
  const auto ply = manager_->export_mesh("two", {MeshFormat::kPly, false, 1}, {});
  EXPECT_THAT(ply.value()->summary().left_out, ElementsAre("materials"));
  EXPECT_TRUE(manager_->export_mesh("two", {MeshFormat::kGlb, false, 1}, {}).is_ok());
  EXPECT_EQ(exported(MeshFormat::kGltf).status().code(), StatusCode::kInvalidArgument);
}

TEST_F(SessionExport, OffIsExportedFromOffOnly) {
  const Status status = exported(MeshFormat::kOff).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("only a scan from a .off file"));
}

TEST_F(SessionExport, EditsLeaveAServerWhoseOriginalIsDamaged) {
  TemporaryFolder& root = library_.root;
  std::ofstream(root / "data/scans" / scan_id_ / "original.obj") << "v 0 0 0\n";
  const auto file = exported(MeshFormat::kObj);
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  EXPECT_EQ(file.value()->summary().triangles, 1280u);
  EXPECT_THAT(file.value()->summary().left_out, ElementsAre(HasSubstr("damaged")));
}

/// A square of some quads whose picture has two halves, as an archive.
std::string textured_archive() {
  const Picture halves = drawn(64, 64, [](uint32_t x, uint32_t) {
    return x < 32 ? Rgba8{60, 60, 60, 255} : Rgba8{190, 190, 190, 255};
  });
  return as_string(packed({{"scan.obj", TexturedGrid{.begin = 0.05, .end = 0.95}.obj()},
                           {"skin.mtl", kSkinMtl},
                           {"skin.png", png_of(halves)}}));
}

TEST_F(SessionExport, EditedColoursAreInThePicturesOfAnArchive) {
  const std::string archive = textured_archive();
  ASSERT_TRUE(library_.import(archive, "skin", {}, 5, MeshFormat::kZip).is_ok());
  ASSERT_TRUE(manager_->open({"skin", "three", {5, 0}}, {}, {}).is_ok());
  const ExportWish wish{MeshFormat::kZip, true};
  const auto before = manager_->export_mesh("three", wish, {});
  ASSERT_TRUE(before.is_ok()) << before.status().message();
  EXPECT_EQ(before.value()->read(0).value(), archive);
  EXPECT_EQ(before.value()->summary().pictures, "");
  const std::vector<Edit> edits = {{"b", SetColour{{5, 0}}}};
  ASSERT_TRUE(manager_->apply("three", {}, edits, {}).is_ok());
  const auto after = manager_->export_mesh("three", wish, {});
  ASSERT_TRUE(after.is_ok()) << after.status().message();
  EXPECT_THAT(after.value()->summary().pictures, HasSubstr("1 of 1 pictures changed"));
  EXPECT_THAT(after.value()->summary().left_out, IsEmpty());
  const auto alone = manager_->export_mesh("three", {MeshFormat::kObj, true}, {});
  EXPECT_THAT(alone.value()->summary().left_out, testing::Contains("edited colours"));
}

TEST_F(SessionExport, LevelledSeamsAreInThePicturesAndUndoGivesTheImportsBytes) {
  const PhotoGrid grid;
  const std::string archive = as_string(packed(
      {{"scan.obj", grid.obj()}, {"skin.mtl", kSkinMtl}, {"skin.png", png_of(grid.picture())}}));
  ASSERT_TRUE(library_.import(archive, "photos", {}, 5, MeshFormat::kZip).is_ok());
  ASSERT_TRUE(manager_->open({"photos", "four", {5, 0}}, {}, {}).is_ok());
  const std::vector<Edit> edits = {{"c", SetTexture{{1, 0, 1}}}};
  ASSERT_TRUE(manager_->apply("four", {}, edits, {}).is_ok());
  const ExportWish wish{MeshFormat::kZip, true};
  const auto after = manager_->export_mesh("four", wish, {});
  ASSERT_TRUE(after.is_ok()) << after.status().message();
  EXPECT_THAT(after.value()->summary().pictures, HasSubstr("seams of 9 charts levelled"));
  EXPECT_THAT(after.value()->summary().left_out, IsEmpty());
  const std::string levelled = after.value()->read(0).value();
  const Archive opened = std::move(Archive::open(as_bytes(levelled), "levelled")).value();
  const Picture picture =
      read_picture(opened.read(opened.find("skin.png").value()).value(), "skin").value();
  EXPECT_LE(grid.median_step(picture), 0.3 * grid.median_step(grid.picture()));
  const auto ply = manager_->export_mesh("four", {MeshFormat::kPly, false, 1}, {});
  EXPECT_THAT(ply.value()->summary().left_out, testing::Contains("levelled seams"));
  const std::vector<Edit> undo = {{"d", Undo{}}};
  ASSERT_TRUE(manager_->apply("four", {}, undo, {}).is_ok());
  EXPECT_EQ(manager_->export_mesh("four", wish, {}).value()->read(0).value(), archive);
}

TEST_F(SessionExport, SeamsOfAScanWithoutPicturesAreRefused) {
  ASSERT_TRUE(library_.import(coloured_sphere(), "bare", {}, 5, MeshFormat::kObj).is_ok());
  ASSERT_TRUE(manager_->open({"bare", "five", {5, 0}}, {}, {}).is_ok());
  const std::vector<Edit> kept = {{"e", SetTexture{{2, 0.5}}}};
  EXPECT_TRUE(manager_->apply("five", {}, kept, {}).is_ok());
  const std::vector<Edit> levelled = {{"f", SetTexture{{1, 0, 1}}}};
  const Status status = manager_->apply("five", {}, levelled, {}).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("no pictures"));
}

TEST_F(SessionExport, AnyScanIsExportedAsAnArchive) {
  const auto file = exported(MeshFormat::kZip);
  ASSERT_TRUE(file.is_ok()) << file.status().message();
  const std::string bytes = file.value()->read(0).value();
  const Archive archive = std::move(Archive::open(as_bytes(bytes), "ball")).value();
  ASSERT_EQ(archive.entries().size(), 1u);
  EXPECT_EQ(archive.entries()[0].name, "ball.obj");
  EXPECT_EQ(as_string(archive.read(0).value()), file_);
}

TEST_F(SessionExport, AnArchivesMeshComesAloneOrWithItsFiles) {
  const std::string archive =
      as_string(packed({{"stone.mtl", "newmtl stone\n"}, {"a.obj", file_}}));
  ASSERT_TRUE(library_.import(archive, "packed", {}, 5, MeshFormat::kZip).is_ok());
  ASSERT_TRUE(manager_->open({"packed", "two", {5, 0}}, {}, {}).is_ok());
  const auto exported_as = [&](MeshFormat format, bool with_files) {
    ExportWish wish{format, false, 1};
    wish.with_files = with_files;
    return manager_->export_mesh("two", wish, {});
  };
  const auto alone = exported_as(MeshFormat::kObj, false);
  ASSERT_TRUE(alone.is_ok()) << alone.status().message();
  EXPECT_EQ(alone.value()->read(0).value(), file_);
  EXPECT_FALSE(alone.value()->summary().is_archive);
  const auto with_files = exported_as(MeshFormat::kObj, true);
  EXPECT_EQ(with_files.value()->read(0).value(), archive);
  EXPECT_TRUE(with_files.value()->summary().is_archive);
  EXPECT_FALSE(exported_as(MeshFormat::kPly, true).value()->summary().is_archive);
  EXPECT_THAT(exported_as(MeshFormat::kOff, true).status().message(), HasSubstr(".obj file"));
  EXPECT_EQ(library_.staged_files(), 0u);
}

}  // namespace
}  // namespace burnish

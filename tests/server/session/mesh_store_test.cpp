#include "server/session/mesh_store.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/prepare/prepared_mesh.h"
#include "server/session/memory_need.h"
#include "server/session/scan_record.h"
#include "tests/server/session/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

fs::path prepared_path(const TestLibrary& library, const ScanInfo& scan) {
  return library.folder->scans() / scan.id / "prepared" / prepared_file_name({5, 0});
}

TEST(MeshStore, AnImportedScanIsListedDescribedAndThereAfterARestart) {
  TestLibrary library;
  const auto outcome = library.import(sphere_file(), "ball");
  ASSERT_TRUE(outcome.is_ok()) << outcome.status().message();
  EXPECT_FALSE(outcome.value().already_present);
  EXPECT_EQ(outcome.value().scan.statistics.vertices, 642u);
  EXPECT_EQ(library.staged_files(), 0u);

  library.restart();
  const auto scans = library.store->list();
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0].name, "ball");
  EXPECT_EQ(scans[0].statistics.triangles, 1280u);
  ASSERT_EQ(scans[0].prepared.size(), 1u);
  EXPECT_EQ(scans[0].prepared[0].key.depth, 5);
}

TEST(MeshStore, TheSameBytesTwiceAreOneScanUnderItsFirstName) {
  TestLibrary library;
  ASSERT_TRUE(library.import(sphere_file(), "ball").is_ok());
  const auto again = library.import(sphere_file(), "globe");
  ASSERT_TRUE(again.is_ok());
  EXPECT_TRUE(again.value().already_present);
  EXPECT_EQ(again.value().scan.name, "ball");
  EXPECT_EQ(library.store->list().size(), 1u);
}

TEST(MeshStore, AScanIsFoundByNameIdAndUniqueBeginning) {
  TestLibrary library;
  const ScanInfo a = library.import(sphere_file(1), "a").value().scan;
  const ScanInfo b = library.import(sphere_file(2), "b").value().scan;
  EXPECT_EQ(library.store->find("a").value().id, a.id);
  EXPECT_EQ(library.store->find(b.id).value().name, "b");
  EXPECT_EQ(library.store->find(a.id.substr(0, 20)).value().name, "a");
  EXPECT_EQ(library.store->find("c-nothing").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(library.store->find("").status().code(), StatusCode::kNotFound);
}

TEST(MeshStore, ANameOfTwoScansIsAmbiguous) {
  TestLibrary library;
  ASSERT_TRUE(library.import(sphere_file(1), "twin").is_ok());
  ASSERT_TRUE(library.import(sphere_file(2), "twin").is_ok());
  EXPECT_THAT(library.store->find("twin").status().message(), HasSubstr("2 scans answer"));
}

TEST(MeshStore, AFileThatIsNoMeshLeavesNothing) {
  TestLibrary library;
  const auto outcome = library.import("ply\nnonsense\n", "bad");
  EXPECT_EQ(outcome.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(outcome.status().message(), HasSubstr("bad"));
  EXPECT_TRUE(library.store->list().empty());
  EXPECT_EQ(library.staged_files(), 0u);
}

TEST(MeshStore, ACancelledImportLeavesNothing) {
  TestLibrary library;
  const auto outcome =
      library.import(sphere_file(), "ball", [](std::string_view, double) { return false; });
  EXPECT_EQ(outcome.status().code(), StatusCode::kCancelled);
  EXPECT_TRUE(library.store->list().empty());
  EXPECT_EQ(library.staged_files(), 0u);
}

TEST(MeshStore, AnUploadAboveTheLimitIsRefusedWithBothNumbers) {
  MeshStoreOptions options;
  options.upload_bytes_max = 100;
  TestLibrary library(options);
  const auto outcome = library.import(std::string(101, 'x'), "big");
  EXPECT_EQ(outcome.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(outcome.status().message(), HasSubstr("101 bytes; upload_bytes_max is 100"));
}

TEST(MeshStore, AMissingOrDamagedPreparedFileIsMadeAgain) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  fs::remove(prepared_path(library, scan));
  EXPECT_TRUE(library.store->open_mesh(scan.id, {5, 0}, {}).is_ok());
  ASSERT_TRUE(fs::exists(prepared_path(library, scan)));

  fs::resize_file(prepared_path(library, scan), 3);
  EXPECT_TRUE(library.store->open_mesh(scan.id, {5, 0}, {}).is_ok());
  EXPECT_GT(fs::file_size(prepared_path(library, scan)), 3u);
}

TEST(MeshStore, APreparedFileOfAnotherVersionIsMadeAgain) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const fs::path path = prepared_path(library, scan);
  const auto size = fs::file_size(path);
  const auto expect_made_again = [&] {
    ASSERT_TRUE(library.store->open_mesh(scan.id, {5, 0}, {}).is_ok());
    EXPECT_EQ(fs::file_size(path), size);
    EXPECT_TRUE(map_prepared_mesh(path).is_ok());
  };
  fs::rename(path, path.parent_path() / "depth5-radius0-format1.prepared");
  EXPECT_TRUE(library.store->find("ball").value().prepared.empty());
  expect_made_again();

  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(8).put(1);
  EXPECT_THAT(map_prepared_mesh(path).status().message(), HasSubstr("format version is 1"));
  expect_made_again();
}

TEST(MeshStore, SessionsShareOneMesh) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const auto first = library.store->open_mesh(scan.id, {5, 0}, {}).value();
  const auto second = library.store->open_mesh(scan.id, {5, 0}, {}).value();
  EXPECT_EQ(first.get(), second.get());
}

TEST(MeshStore, AMeshBeyondTheMemoryBudgetIsRefusedWithTheNumbers) {
  MeshStoreOptions options;
  options.memory_bytes_max = 1000;
  TestLibrary library(options);
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const auto mesh = library.store->open_mesh(scan.id, {5, 0}, {});
  EXPECT_EQ(mesh.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(mesh.status().message(), HasSubstr("limits.memory_bytes_max is 1000"));
}

// Specks far from each other have corners of their own at all depths: more than is predicted.
TriangleMesh specks() {
  TriangleMesh mesh;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 4; ++z) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        for (int i = 0; i < 3; ++i)
          mesh.vertices.push_back(Vec3d(x, y, z) / 4 + 1e-3 * Vec3d::Unit(i));
        mesh.triangles.push_back({first, first + 1, first + 2});
      }
  return mesh;
}

TEST(MeshStore, AMeshOfDustCountsWithAllItsBytes) {
  TestLibrary library;
  const ScanInfo scan = library.import(mesh_file(specks()), "dust", {}, 8).value().scan;
  const auto mesh = library.store->open_mesh(scan.id, {8, 0}, {}).value();
  ASSERT_GT(mesh->byte_count(), predict_mesh_bytes(*mesh->prepared));
  EXPECT_EQ(mesh->memory.amount(), mesh->byte_count());
}

TEST(MeshStore, ADamagedScanIsLeftOutOfTheList) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  std::ofstream(library.folder->scans() / scan.id / "info.json") << "{\"id\": 3}";
  EXPECT_TRUE(library.store->list().empty());
}

TEST(MeshStore, ARemovedScanIsGone) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  ASSERT_TRUE(library.store->remove(scan.id).is_ok());
  EXPECT_TRUE(library.store->list().empty());
  EXPECT_FALSE(fs::exists(library.folder->scans() / scan.id));
}

TEST(ScanRecord, PreparedFileNamesCarryTheKey) {
  for (const PreparedKey& key : {PreparedKey{5, 0}, PreparedKey{12, 0.1}, PreparedKey{9, 1.0 / 3}})
    EXPECT_EQ(parse_prepared_file_name(prepared_file_name(key)), key);
  EXPECT_FALSE(parse_prepared_file_name("depth5-radius0-format999.prepared"));
  EXPECT_FALSE(parse_prepared_file_name("readme.txt"));
}

}  // namespace
}  // namespace burnish

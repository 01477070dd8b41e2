#include "server/library/mesh_store.h"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "common/transfer/chunk.h"
#include "server/library/scan_names.h"
#include "server/library/scan_record.h"
#include "server/memory/opening_need.h"
#include "server/prepare/prepared_file.h"
#include "server/prepare/prepared_mesh.h"
#include "tests/server/manager/test_library.h"

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

TEST(MeshStore, ARenamedScanIsTheSameScanAndKeepsItsNameOverARestart) {
  TestLibrary library;
  const ScanInfo ball = library.import(sphere_file(), "ball").value().scan;
  const auto renamed = library.store->rename("ball", "globe");
  ASSERT_TRUE(renamed.is_ok()) << renamed.status().message();
  EXPECT_EQ(renamed->id, ball.id);
  EXPECT_EQ(renamed->prepared.size(), ball.prepared.size());
  library.restart();
  EXPECT_EQ(library.store->find("globe")->id, ball.id);
  EXPECT_EQ(library.store->find("ball").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(library.store->rename("ball", "cube").status().code(), StatusCode::kNotFound);
}

TEST(MeshStore, AScanKeepsItsUnitOverARestart) {
  TestLibrary library;
  ASSERT_TRUE(library.import(sphere_file(), "ball").is_ok());
  EXPECT_EQ(library.store->find("ball")->unit, "");
  EXPECT_EQ(library.store->set_unit("ball", "mm")->unit, "mm");
  library.restart();
  EXPECT_EQ(library.store->find("ball")->unit, "mm");
}

Result<ImportOutcome> import_exactly(TestLibrary& library, const std::string& bytes,
                                     const std::string& name) {
  const ImportHeader header{name, MeshFormat::kPly, bytes.size(), "", {5, 0}, true};
  ASSIGN_OR_RETURN(const auto upload, library.store->begin_upload(header));
  RETURN_IF_ERROR(upload->append(0, bytes, chunk_crc32(bytes)));
  return library.store->import(*upload, header, {});
}

TEST(MeshStore, AnotherScansNameOrItsLookIsRefusedAndTheSameBytesAreNot) {
  TestLibrary library;
  const ScanInfo first = library.import(sphere_file(1), "twin").value().scan;
  for (const char* name : {"twin", "Twin", "t\u200dwin"}) {
    const Status refused = import_exactly(library, sphere_file(2), name).status();
    EXPECT_EQ(refused.code(), StatusCode::kAlreadyExists) << name;
    EXPECT_THAT(refused.message(), HasSubstr(short_id(first.id)));
  }
  EXPECT_TRUE(import_exactly(library, sphere_file(1), "twin")->already_present);
  EXPECT_TRUE(import_exactly(library, sphere_file(1), "face").value().already_present);
  EXPECT_EQ(library.store->find("twin")->id, first.id);
  EXPECT_EQ(library.staged_files(), 0u);
}

TEST(MeshStore, TwoWhoGiveTheSameBytesTheSameNameAtOnceBothMay) {
  const ScanIndex index;
  ScanNames names(index);
  const auto first = names.hold("id-a", "twin", true);
  ASSERT_TRUE(first.is_ok());
  {
    const auto second = names.hold("id-a", "twin", true);
    ASSERT_TRUE(second.is_ok());
    EXPECT_EQ(second->name(), "twin");
  }
  EXPECT_EQ(names.hold("id-b", "twin", true).status().code(), StatusCode::kAlreadyExists);
}

TEST(MeshStore, ARenamedScanTakesNoOthersNameAndMayTakeItsOwnInAnotherCase) {
  TestLibrary library;
  ASSERT_TRUE(library.import(sphere_file(1), "one").is_ok());
  ASSERT_TRUE(library.import(sphere_file(2), "two").is_ok());
  EXPECT_EQ(library.store->rename("two", "one").status().code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(library.store->rename("two", "beef").status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(library.store->rename("two", "Two")->name, "Two");
  EXPECT_EQ(library.store->rename("Two", "three")->name, "three");
  EXPECT_EQ(library.store->rename("one", "two")->name, "two");
}

TEST(MeshStore, AnImportWhoseNameNeedNotBeExactGetsAFreeOne) {
  TestLibrary library;
  const auto import = [&](int size, const std::string& name) {
    return library.import(sphere_file(size), name).value().scan.name;
  };
  EXPECT_EQ(import(1, "scan"), "scan");
  EXPECT_EQ(import(2, "scan"), "scan (2)");
  EXPECT_EQ(import(3, "face "), "face (1)");
  EXPECT_EQ(import(1, "scan"), "scan");
}

TEST(MeshStore, FewerThanFourDigitsAreNotTheBeginningOfAnId) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  EXPECT_TRUE(library.store->find(scan.id.substr(0, 4)).is_ok());
  EXPECT_EQ(library.store->find(scan.id.substr(0, 3)).status().code(), StatusCode::kNotFound);
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
  EXPECT_THAT(outcome.status().message(), HasSubstr("101 bytes; limits.upload_bytes_max is 100"));
}

TEST(MeshStore, AMissingOrDamagedPreparedFileIsMadeAgain) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  fs::remove(prepared_path(library, scan));
  EXPECT_TRUE(library.store->open_mesh(scan.id, {5, 0}, {}).is_ok());
  ASSERT_TRUE(fs::exists(prepared_path(library, scan)));

  fs::remove_all(prepared_path(library, scan).parent_path());
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
    EXPECT_TRUE(read_prepared_mesh(path).is_ok());
  };
  fs::rename(path, path.parent_path() / "depth5-radius0-format1.prepared");
  library.restart();
  EXPECT_TRUE(library.store->find("ball").value().prepared.empty());
  expect_made_again();

  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(8).put(1);
  EXPECT_THAT(read_prepared_mesh(path).status().message(), HasSubstr("format version is 1"));
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
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  library.restart({.memory_bytes_max = 1000});
  const auto mesh = library.store->open_mesh(scan.id, {5, 0}, {});
  EXPECT_EQ(mesh.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(mesh.status().message(), HasSubstr("limits.memory_bytes_max is 1000"));
}

// Specks far from each other have their own corners at all depths: more than predicted.
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
  const PreparedPlace place = place_of_prepared(mesh->prepared->byte_count());
  ASSERT_GT(mesh->byte_count(), predict_mesh_bytes(*mesh->prepared, place));
  EXPECT_EQ(mesh->memory.amount(), mesh->byte_count());
}

TEST(MeshStore, LargePreparedDataLieInAFileAndTakeNoMemory) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const auto small = library.store->open_mesh(scan.id, {5, 0}, {}).value();
  const auto large = library.store->open_mesh(scan.id, {7, 0}, {}).value();
  EXPECT_FALSE(small->prepared->is_in_file);
  EXPECT_TRUE(large->prepared->is_in_file);
  EXPECT_LT(large->memory.amount(), large->prepared->byte_count());
  const auto read = read_prepared_mesh(library.folder->scans() / scan.id / "prepared" /
                                       prepared_file_name({7, 0}));
  EXPECT_FALSE(read.value()->is_in_file);
  EXPECT_EQ(make_prepared_header(*read.value()).checksum,
            make_prepared_header(*large->prepared).checksum);
}

TEST(MeshStore, APreparedFileThatIsCutLeavesWhoHasItOpenAllItsData) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const auto mesh = library.store->open_mesh(scan.id, {7, 0}, {}).value();
  const uint64_t checksum = make_prepared_header(*mesh->prepared).checksum;
  fs::resize_file(library.folder->scans() / scan.id / "prepared" / prepared_file_name({7, 0}), 0);
  EXPECT_EQ(make_prepared_header(*mesh->prepared).checksum, checksum);
}

TEST(MeshStore, ADamagedScanIsLeftOutOfTheList) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  std::ofstream(library.folder->scans() / scan.id / "info.json") << "{\"id\": 3}";
  library.restart();
  EXPECT_TRUE(library.store->list().empty());
}

TEST(MeshStore, ARemovedScanIsGone) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  ASSERT_TRUE(library.store->remove(scan.id).is_ok());
  EXPECT_TRUE(library.store->list().empty());
  EXPECT_FALSE(fs::exists(library.folder->scans() / scan.id));
}

/// A square of two triangles: a few hundred bytes, but gigabytes of cells at depth 11.
std::string square_file() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0.1}, {0, 1, 0.3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh_file(mesh);
}

constexpr uint64_t kLittleMemory = uint64_t{64} << 20;

void expect_refusal_at_depth_11(const Status& status) {
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("at depth 11 takes"));
  EXPECT_THAT(status.message(), HasSubstr("; depth 7 fits"));
}

TEST(MeshStore, ADepthThatTheMemoryHasNoRoomForIsRefusedBeforeItIsPrepared) {
  TestLibrary library({.memory_bytes_max = kLittleMemory});
  expect_refusal_at_depth_11(library.import(square_file(), "square", {}, 11).status());
  EXPECT_EQ(library.staged_files(), 0u);
  const ScanInfo scan = library.import(square_file(), "square", {}, 7).value().scan;
  expect_refusal_at_depth_11(library.store->prepare_scan(scan.id, {11, 0}, {}));
  expect_refusal_at_depth_11(library.store->open_mesh(scan.id, {11, 0}, {}).status());
  EXPECT_FALSE(
      fs::exists(library.folder->scans() / scan.id / "prepared" / prepared_file_name({11, 0})));
  EXPECT_EQ(library.store->memory().taken(), 0u);
  EXPECT_TRUE(library.store->open_mesh(scan.id, {7, 0}, {}).is_ok());
}

TEST(MeshStore, AScanForWhichTheMemoryHasNoRoomIsRefused) {
  TestLibrary library({.memory_bytes_max = 100'000});
  const auto outcome = library.import(sphere_file(), "ball");
  EXPECT_EQ(outcome.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(outcome.status().message(), HasSubstr("limits.memory_bytes_max is 100000"));
}

TEST(MeshStore, OnlySoManyPreparedMeshesOfAScanAreKeptAndThoseInUseStay) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const auto in_use = library.store->open_mesh(scan.id, {5, 0}, {}).value();
  const PreparedKey wanted{4, 0.1};
  library.store->set_wanted([&](const std::string& id, const PreparedKey& key) {
    return id == scan.id && key == wanted;
  });
  ASSERT_TRUE(library.store->prepare_scan(scan.id, wanted, {}).is_ok());
  for (int i = 1; i <= 20; ++i)
    ASSERT_TRUE(library.store->prepare_scan(scan.id, {4, 0.001 * i}, {}).is_ok());
  const auto have = library.store->find("ball").value().prepared;
  EXPECT_EQ(have.size(), kPreparedPerScanMax);
  const auto has = [&](const PreparedKey& key) {
    return std::ranges::find(have, key, &PreparedInfo::key) != have.end();
  };
  EXPECT_TRUE(has({5, 0}));
  EXPECT_TRUE(has(wanted));
  EXPECT_TRUE(has({4, 0.02}));
  EXPECT_FALSE(has({4, 0.001}));
}

TEST(MeshStore, AFileThatIsCutWhileItsMeshIsInUseHarmsNobody) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const auto mesh = library.store->open_mesh(scan.id, {5, 0}, {}).value();
  fs::resize_file(prepared_path(library, scan), 0);
  double sum = 0;
  for (const CellIntegrals& integrals : mesh->prepared->integrals) sum += integrals.mass_row_sum[0];
  EXPECT_GT(sum, 0);
}

TEST(MeshStore, ListsAndFindsWithoutTheDisk) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  fs::rename(library.folder->scans(), library.root / "elsewhere");
  EXPECT_EQ(library.store->list().size(), 1u);
  EXPECT_EQ(library.store->find("ball").value().id, scan.id);
}

TEST(MeshStore, ALibraryThatCannotBeReadIsNotAnEmptyOne) {
  TestLibrary library;
  fs::remove_all(library.folder->scans());
  const auto store = MeshStore::open(*library.folder, {});
  EXPECT_EQ(store.status().code(), StatusCode::kNotFound);
  EXPECT_THAT(store.status().message(), HasSubstr("cannot list the scans"));
}

TEST(ScanRecord, PreparedFileNamesCarryTheKey) {
  for (const PreparedKey& key : {PreparedKey{5, 0}, PreparedKey{12, 0.1}, PreparedKey{9, 1.0 / 3}})
    EXPECT_EQ(parse_prepared_file_name(prepared_file_name(key)), key);
  EXPECT_FALSE(parse_prepared_file_name("depth5-radius0-format999.prepared"));
  EXPECT_FALSE(parse_prepared_file_name("readme.txt"));
}

}  // namespace
}  // namespace burnish

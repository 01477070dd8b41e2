#include <fstream>

#include <gtest/gtest.h>

#include "server/library/scan_record.h"
#include "server/library/stale_files.h"
#include "tests/server/manager/test_library.h"
#include "tests/server/solver/hierarchy_bytes.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr PreparedKey kKey{5, 0};

/// A library with a sphere whose hierarchy is kept in a file.
class KeptHierarchy : public testing::Test {
 protected:
  KeptHierarchy() {
    scan_ = library_.import(sphere_file(), "ball").value().scan;
    const auto made = open();
    EXPECT_FALSE(made->is_kept);
    made_ = HierarchyBytes::of(*made->hierarchy) + HierarchyBytes::of(*made->plan);
    keep(made);
  }

  std::shared_ptr<const SharedMesh> open() {
    return library_.store->open_mesh(scan_.id, kKey, {}).value();
  }
  void keep(const std::shared_ptr<const SharedMesh>& mesh) {
    library_.store->keep_hierarchy(scan_.id, kKey, mesh).wait();
  }

  fs::path folder() const { return library_.folder->scans() / scan_.id / "prepared"; }
  fs::path path() const { return folder() / hierarchy_file_name(kKey); }

  /// Opens the mesh again. Returns whether its hierarchy came from the file.
  bool comes_from_the_file() {
    const auto mesh = open();
    EXPECT_TRUE(HierarchyBytes::of(*mesh->hierarchy) + HierarchyBytes::of(*mesh->plan) == made_);
    EXPECT_LE(mesh->byte_count(), mesh->memory.amount());
    return mesh->is_kept;
  }

  TestLibrary library_;
  ScanInfo scan_;
  std::string made_;
};

TEST_F(KeptHierarchy, IsReadAtTheNextOpeningAndByTheNextServer) {
  EXPECT_TRUE(comes_from_the_file());
  library_.restart();
  EXPECT_TRUE(comes_from_the_file());
}

TEST_F(KeptHierarchy, IsWrittenOnce) {
  const fs::file_time_type written = fs::last_write_time(path());
  keep(open());
  EXPECT_EQ(fs::last_write_time(path()), written);
}

TEST_F(KeptHierarchy, ThatIsDamagedShortOrForeignIsMadeAnewAndKeptAgain) {
  const std::string good = content_of(path());
  std::string flipped = good;
  flipped[good.size() / 2] ^= 1;
  for (const std::string& bad :
       {flipped, good.substr(0, 100), std::string(), std::string(500, 0x3f)}) {
    std::ofstream(path(), std::ios::binary) << bad;
    EXPECT_FALSE(comes_from_the_file());
    keep(open());
    EXPECT_TRUE(content_of(path()) == good);
  }
}

TEST_F(KeptHierarchy, OfAnotherPreparedMeshIsMadeAnew) {
  const std::string of_ball = content_of(path());
  scan_ = library_.import(sphere_file(2), "globe").value().scan;
  std::ofstream(path(), std::ios::binary) << of_ball;
  EXPECT_FALSE(open()->is_kept);
}

TEST_F(KeptHierarchy, CountsInTheBytesOfItsScan) {
  const ScanInfo scan = library_.store->find("ball").value();
  const fs::path prepared = folder() / prepared_file_name(kKey);
  EXPECT_EQ(scan.prepared.at(0).size_bytes, fs::file_size(prepared) + fs::file_size(path()));
}

TEST_F(KeptHierarchy, GoesWithItsScan) {
  ASSERT_TRUE(library_.store->remove(scan_.id).is_ok());
  EXPECT_FALSE(fs::exists(path()));
}

TEST_F(KeptHierarchy, GoesWithItsPreparedMesh) {
  for (int i = 1; i <= 20; ++i)
    ASSERT_TRUE(library_.store->prepare_scan(scan_.id, {4, 0.001 * i}, {}).is_ok());
  EXPECT_FALSE(fs::exists(folder() / prepared_file_name(kKey)));
  EXPECT_FALSE(fs::exists(path()));
}

TEST_F(KeptHierarchy, OfADeletedScanIsNotWrittenAndHarmsNobody) {
  const auto mesh = open();
  mesh->is_kept = false;
  ASSERT_TRUE(library_.store->remove(scan_.id).is_ok());
  keep(mesh);
  EXPECT_FALSE(fs::exists(folder()));
  EXPECT_TRUE(library_.store->list().empty());
}

TEST_F(KeptHierarchy, OfAnotherVersionIsStale) {
  const fs::path other = folder() / "depth5-radius0-format999.hierarchy";
  fs::copy(path(), other);
  std::ofstream(folder() / (hierarchy_file_name(kKey) + ".4711-3.tmp")) << "burnhie\n";
  EXPECT_EQ(remove_stale_files(*library_.folder).count, 2u);
  EXPECT_FALSE(fs::exists(other));
  EXPECT_TRUE(comes_from_the_file());
}

TEST_F(KeptHierarchy, CannotBeWrittenIsNoFailureOfTheSession) {
  fs::remove(path());
  fs::create_directories(path());  // a folder in the place of the file
  const auto mesh = open();
  EXPECT_FALSE(mesh->is_kept);
  keep(mesh);
  EXPECT_TRUE(fs::is_directory(path()));
}

TEST(PagesOfAScan, AreDescribedAndReadWhileItsHierarchyIsMade) {
  TestLibrary library;
  const ScanInfo scan = library.import(sphere_file(), "ball").value().scan;
  const Progress never = [](std::string_view, double) { return false; };  // waits for nothing
  bool was_asked = false;
  const auto mesh = library.store->open_mesh(scan.id, kKey, [&](std::string_view phase, double) {
    if (phase != "connecting cells" || was_asked) return true;
    was_asked = true;
    const auto pages = library.store->describe_pages(scan.id, never);
    EXPECT_TRUE(pages.is_ok()) << pages.status().message();
    size_t count = 0;
    const auto take = [&](const PagePart&) { ++count; };
    EXPECT_TRUE(library.store->read_pages(scan.id, {scan.id, {}, {0}}, {take, take}, {}).is_ok());
    EXPECT_EQ(count, 1u);
    return true;
  });
  EXPECT_TRUE(mesh.is_ok());
  EXPECT_TRUE(was_asked);
}

}  // namespace
}  // namespace burnish

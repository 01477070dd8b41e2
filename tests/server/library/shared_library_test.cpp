// Two servers with folders of their own, one shared folder, and a catalogue in memory.

#include <map>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/library/scan_record.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// What a database does, without one.
struct CatalogueRows {
  std::mutex mutex;
  std::map<std::string, ScanInfo> scans;
  std::string editing;  ///< the session that edits every scan; "": none
  int version = 0;
};

class CatalogueInMemory final : public ScanCatalogue {
 public:
  explicit CatalogueInMemory(CatalogueRows& rows) : rows_(rows) {}

  Result<std::optional<Page>> read(const std::string& mark) override {
    const std::lock_guard lock(rows_.mutex);
    Page page{"version " + std::to_string(rows_.version), {}};
    if (page.mark == mark) return std::optional<Page>();
    for (const auto& [id, scan] : rows_.scans) page.scans.push_back(scan);
    return std::optional<Page>(std::move(page));
  }
  Result<ScanInfo> enter(const ScanInfo& scan, const Files& put) override {
    const std::lock_guard lock(rows_.mutex);
    RETURN_IF_ERROR(put());
    ++rows_.version;
    ScanInfo entered = scan;
    entered.prepared.clear();
    return rows_.scans.try_emplace(scan.id, entered).first->second;
  }
  Result<ScanInfo> change(const std::string& id,
                          const std::function<void(ScanInfo&)>& by) override {
    const std::lock_guard lock(rows_.mutex);
    ++rows_.version;
    by(rows_.scans.at(id));
    return rows_.scans.at(id);
  }
  Status remove(const std::string& id, const Files& remove_files) override {
    const std::lock_guard lock(rows_.mutex);
    if (!rows_.editing.empty()) return failed_precondition("session " + rows_.editing);
    RETURN_IF_ERROR(remove_files());
    ++rows_.version;
    rows_.scans.erase(id);
    return Status::ok();
  }

 private:
  CatalogueRows& rows_;
};

class SharedLibraryTest : public testing::Test {
 protected:
  SharedLibraryTest() {
    share(one_, "one");
    share(two_, "two");
  }

  void share(TestLibrary& library, const std::string& name) {
    SharedLibrary shared;
    shared.folder = std::move(SharedFolder::open(shared_.path(), name)).value();
    shared.catalogue = std::make_unique<CatalogueInMemory>(rows_);
    const Status status = library.store->share(std::move(shared));
    EXPECT_TRUE(status.is_ok()) << status.message();
  }

  fs::path shared_original(const ScanInfo& scan) const {
    return shared_ / "scans" / scan.id / original_file_name(scan.format);
  }
  static fs::path own_folder(const TestLibrary& library, const ScanInfo& scan) {
    return library.folder->scans() / scan.id;
  }
  size_t staged(const std::string& server) const {
    const fs::directory_iterator files(shared_ / "staging" / server);
    return static_cast<size_t>(std::distance(begin(files), end(files)));
  }

  const TemporaryFolder shared_;
  CatalogueRows rows_;
  TestLibrary one_, two_;
};

TEST_F(SharedLibraryTest, AScanOfOneServerOpensOnTheOtherFromItsOwnCopy) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  EXPECT_EQ(two_.store->find("ball")->id, ball.id);
  EXPECT_FALSE(fs::exists(own_folder(two_, ball))) << "nobody has needed it there yet";
  const auto mesh = two_.store->open_mesh(ball.id, {5, 0}, {});
  ASSERT_TRUE(mesh.is_ok()) << mesh.status().message();
  EXPECT_EQ(content_of(own_folder(two_, ball) / "original.ply"), sphere_file());
  fs::remove_all(shared_ / "scans");
  EXPECT_TRUE(two_.store->open_pages(ball.id, {}).is_ok()) << "its own copy is enough";
  EXPECT_EQ(staged("one") + staged("two") + one_.staged_files() + two_.staged_files(), 0u);
}

TEST_F(SharedLibraryTest, PagesAndOriginalsAreFetchedToo) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  const ScanInfo globe = one_.import(sphere_file(2), "globe")->scan;
  ASSERT_TRUE(two_.store->refresh().is_ok());
  EXPECT_TRUE(two_.store->describe_pages(ball.id, {}).is_ok());
  const auto original = two_.store->find_original(globe.id, {});
  ASSERT_TRUE(original.is_ok());
  EXPECT_EQ(content_of(original->path), sphere_file(2));
}

TEST_F(SharedLibraryTest, NamesAndUnitsAreTheSameEverywhere) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(two_.store->rename("ball", "globe").is_ok());
  ASSERT_TRUE(two_.store->set_unit("globe", "mm").is_ok());
  ASSERT_TRUE(one_.store->refresh().is_ok());
  EXPECT_EQ(one_.store->list()[0].name, "globe");
  EXPECT_EQ(one_.store->list()[0].unit, "mm");
  EXPECT_EQ(one_.store->list()[0].prepared.size(), 1u) << "its own prepared mesh stays";
  one_.restart();
  EXPECT_EQ(one_.store->list()[0].name, "globe") << "it is in its own folder as well";
}

TEST_F(SharedLibraryTest, TheSameBytesOnTwoServersAreOneScanUnderItsFirstName) {
  ASSERT_TRUE(one_.import(sphere_file(), "ball").is_ok());
  const auto again = two_.import(sphere_file(), "globe");
  ASSERT_TRUE(again.is_ok()) << again.status().message();
  EXPECT_TRUE(again->already_present);
  EXPECT_EQ(again->scan.name, "ball");
}

TEST_F(SharedLibraryTest, KnownBytesNeedNoUpload) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  const auto known = two_.store->import_known(ball.id, {5, 0}, {});
  ASSERT_TRUE(known.is_ok()) << known.status().message();
  EXPECT_EQ(known->scan.prepared.size(), 1u);
}

TEST_F(SharedLibraryTest, ADeletedScanIsGoneEverywhereAndDoesNotComeBackWithAServer) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(two_.store->open_mesh(two_.store->find("ball")->id, {5, 0}, {}).is_ok());
  one_.restart();  // away while the scan is deleted
  ASSERT_TRUE(two_.store->remove(ball.id).is_ok());
  EXPECT_FALSE(fs::exists(shared_ / "scans" / ball.id));
  EXPECT_FALSE(fs::exists(own_folder(two_, ball)));
  share(one_, "one");
  EXPECT_TRUE(one_.store->list().empty());
  EXPECT_FALSE(fs::exists(own_folder(one_, ball)));
  EXPECT_TRUE(one_.import(sphere_file(), "ball").is_ok()) << "it may be imported again";
}

TEST_F(SharedLibraryTest, AScanThatComesAndGoesBetweenTwoReadsIsGone) {
  const int before = rows_.version;
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(two_.store->refresh().is_ok());
  ASSERT_TRUE(two_.store->remove(ball.id).is_ok());
  rows_.version = before;  // an empty catalogue is like another
  ASSERT_TRUE(one_.store->refresh().is_ok());
  EXPECT_TRUE(one_.store->list().empty());
}

TEST_F(SharedLibraryTest, AScanThatASessionOfAnyServerEditsStays) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  rows_.editing = "work";
  const Status refused = one_.store->remove(ball.id);
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("session work"));
  EXPECT_TRUE(fs::exists(own_folder(one_, ball)));
  EXPECT_TRUE(fs::exists(shared_original(ball)));
}

TEST_F(SharedLibraryTest, AServerThatWasAloneSharesItsScans) {
  TestLibrary three;
  const ScanInfo cube = three.import(sphere_file(3), "cube")->scan;
  share(three, "three");
  EXPECT_TRUE(fs::exists(shared_original(cube)));
  EXPECT_TRUE(one_.store->open_mesh(one_.store->find("cube")->id, {5, 0}, {}).is_ok());
}

TEST_F(SharedLibraryTest, ADamagedSharedOriginalIsNotUsedAndTheNextImportMakesItGood) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  std::string damaged = sphere_file();
  damaged[damaged.size() / 2] ^= 1;
  std::ofstream(shared_original(ball), std::ios::binary) << damaged;
  ASSERT_TRUE(two_.store->refresh().is_ok());
  const Status refused = two_.store->open_mesh(ball.id, {5, 0}, {}).status();
  EXPECT_EQ(refused.code(), StatusCode::kDataLoss);
  EXPECT_THAT(refused.message(), HasSubstr("scan ball"));
  EXPECT_THAT(refused.message(), testing::Not(HasSubstr(shared_.path().string())));
  EXPECT_EQ(two_.store->import_known(ball.id, {5, 0}, {}).status().code(), StatusCode::kNotFound);
  ASSERT_TRUE(two_.import(sphere_file(), "ball").is_ok());
  EXPECT_EQ(content_of(shared_original(ball)), sphere_file());
  EXPECT_TRUE(two_.store->open_mesh(ball.id, {5, 0}, {}).is_ok());
}

TEST_F(SharedLibraryTest, ADamagedOwnOriginalIsFetchedAgain) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  fs::resize_file(own_folder(one_, ball) / "original.ply", 5);
  EXPECT_TRUE(one_.store->prepare_scan(ball.id, {4, 0}, {}).is_ok());
  EXPECT_EQ(content_of(own_folder(one_, ball) / "original.ply"), sphere_file());
}

TEST_F(SharedLibraryTest, AFailedImportIsNowhere) {
  const auto failed = one_.import("ply\nnonsense\n", "bad");
  EXPECT_FALSE(failed.is_ok());
  EXPECT_TRUE(rows_.scans.empty());
  EXPECT_EQ(staged("one"), 0u);
  EXPECT_FALSE(fs::exists(shared_ / "scans") && !fs::is_empty(shared_ / "scans"));
}

TEST_F(SharedLibraryTest, ACancelledFetchLeavesNothing) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(two_.store->refresh().is_ok());
  const auto cancelled =
      two_.store->open_mesh(ball.id, {5, 0}, [](std::string_view, double) { return false; });
  EXPECT_EQ(cancelled.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(two_.staged_files(), 0u);
  EXPECT_FALSE(fs::exists(own_folder(two_, ball)));
}

TEST_F(SharedLibraryTest, AServersUnfinishedFilesGoAtItsStartAndNobodyElsesDo) {
  for (const char* name : {"one", "two"})
    fs::create_directories(shared_ / "staging" / name / "half");
  ASSERT_TRUE(SharedFolder::open(shared_.path(), "one").is_ok());
  EXPECT_EQ(staged("one"), 0u);
  EXPECT_EQ(staged("two"), 1u);
}

TEST(SharedFolder, AFolderThatIsNotMountedIsRefused) {
  const Status refused = SharedFolder::open("/nowhere/burnish", "one").status();
  EXPECT_EQ(refused.code(), StatusCode::kNotFound);
  EXPECT_THAT(refused.message(), HasSubstr("/nowhere/burnish"));
}

TEST(SharedFolder, ARenameThatTheFileSystemRepeatsIsASuccess) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "from");
  const auto is_there = [&] { return fs::exists(folder / "to"); };
  EXPECT_TRUE(rename_once(folder / "from", folder / "to", is_there).is_ok());
  EXPECT_TRUE(rename_once(folder / "from", folder / "to", is_there).is_ok()) << "NFS's second try";
  EXPECT_EQ(rename_once(folder / "from", folder / "else", [] { return false; }).code(),
            StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish

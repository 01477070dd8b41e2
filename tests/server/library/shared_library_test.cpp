// Two servers with folders of their own, one store of originals, and a catalogue in memory.

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/transfer/chunk.h"
#include "server/library/scan_record.h"
#include "server/library/shared_folder.h"
#include "tests/server/library/catalogue_in_memory.h"
#include "tests/server/library/shared_place.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class SharedLibraryTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const std::string why = missing_for(GetParam()); !why.empty()) GTEST_SKIP() << why;
    shared_ = make_shared_place(GetParam());
    share(one_, "one");
    share(two_, "two");
  }

  void share(TestLibrary& library, const std::string& name) {
    SharedLibrary shared;
    shared.originals = shared_->open(name);
    shared.catalogue = std::make_unique<CatalogueInMemory>(rows_);
    const Status status = library.store->share(std::move(shared));
    EXPECT_TRUE(status.is_ok()) << status.message();
  }

  static fs::path own_folder(const TestLibrary& library, const ScanInfo& scan) {
    return library.folder->scans() / scan.id;
  }
  void damage(const ScanInfo& scan) const {
    std::string damaged = shared_->original(scan);
    damaged.at(damaged.size() / 2) ^= 1;
    shared_->put_original(scan, damaged);
  }

  std::unique_ptr<SharedPlace> shared_;
  CatalogueRows rows_;
  TestLibrary one_, two_;
};

INSTANTIATE_TEST_SUITE_P(Stores, SharedLibraryTest, testing::Values("Folder", "Bucket"),
                         [](const auto& store) { return std::string(store.param); });

TEST_P(SharedLibraryTest, AScanOfOneServerOpensOnTheOtherFromItsOwnCopy) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  EXPECT_EQ(two_.store->find("ball")->id, ball.id);
  EXPECT_FALSE(fs::exists(own_folder(two_, ball))) << "nobody has needed it there yet";
  const auto mesh = two_.store->open_mesh(ball.id, {5, 0}, {});
  ASSERT_TRUE(mesh.is_ok()) << mesh.status().message();
  EXPECT_EQ(content_of(own_folder(two_, ball) / "original.ply"), sphere_file());
  shared_->clear();
  EXPECT_TRUE(two_.store->open_pages(ball.id, {}).is_ok()) << "its own copy is enough";
  EXPECT_EQ(shared_->unfinished() + one_.staged_files() + two_.staged_files(), 0u);
}

TEST_P(SharedLibraryTest, PagesAndOriginalsAreFetchedToo) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  const ScanInfo globe = one_.import(sphere_file(2), "globe")->scan;
  ASSERT_TRUE(two_.store->refresh().is_ok());
  EXPECT_TRUE(two_.store->describe_pages(ball.id, {}).is_ok());
  const auto original = two_.store->find_original(globe.id, {});
  ASSERT_TRUE(original.is_ok());
  EXPECT_EQ(content_of(original->path), sphere_file(2));
}

TEST_P(SharedLibraryTest, NamesAndUnitsAreTheSameEverywhere) {
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

TEST_P(SharedLibraryTest, TheSameBytesOnTwoServersAreOneScanUnderItsFirstName) {
  ASSERT_TRUE(one_.import(sphere_file(), "ball").is_ok());
  const auto again = two_.import(sphere_file(), "globe");
  ASSERT_TRUE(again.is_ok()) << again.status().message();
  EXPECT_TRUE(again->already_present);
  EXPECT_EQ(again->scan.name, "ball");
}

/// Lets another server enter a scan of this name once an import has chosen its own.
Progress enter_meanwhile(CatalogueRows& rows, const std::string& name) {
  return [&rows, name](std::string_view phase, double) {
    const std::lock_guard lock(rows.mutex);
    if (phase != "storing" || !rows.scans.empty()) return true;
    ScanInfo other;
    other.id = std::string(64, 'b');
    other.name = name;
    rows.scans[other.id] = other;
    ++rows.version;
    return true;
  };
}

TEST_P(SharedLibraryTest, ANameThatAnotherServerGivesDuringAnImportIsNotGivenTwice) {
  const auto ball = one_.import(sphere_file(), "ball", enter_meanwhile(rows_, "Ball"));
  ASSERT_TRUE(ball.is_ok()) << ball.status().message();
  EXPECT_EQ(ball->scan.name, "ball (2)");
  ASSERT_TRUE(two_.store->refresh().is_ok());
  EXPECT_EQ(two_.store->find("ball (2)")->id, ball->scan.id);
}

TEST_P(SharedLibraryTest, AnExactNameThatAnotherServerGivesDuringAnImportIsRefused) {
  const std::string bytes = sphere_file();
  ImportHeader header{"ball", MeshFormat::kPly, bytes.size(), "", {5, 0}};
  header.exact_name = true;
  const auto upload = one_.store->begin_upload(header).value();
  ASSERT_TRUE(upload->append(0, bytes, chunk_crc32(bytes)).is_ok());
  const auto refused = one_.store->import(*upload, header, enter_meanwhile(rows_, "Ball"));
  EXPECT_EQ(refused.status().code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(rows_.scans.size(), 1u);
  EXPECT_EQ(shared_->file_count() + shared_->unfinished(), 0u) << "nothing is kept";
}

TEST_P(SharedLibraryTest, AServerThatJoinsWithANameInUseKeepsItsScanUnderAnother) {
  ASSERT_TRUE(one_.import(sphere_file(), "ball").is_ok());
  TestLibrary alone;
  const ScanInfo own = alone.import(sphere_file(2), "ball")->scan;
  share(alone, "three");
  EXPECT_EQ(alone.store->find("ball (2)")->id, own.id);
}

TEST_P(SharedLibraryTest, KnownBytesNeedNoUpload) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  const auto known = two_.store->import_known(ball.id, {5, 0}, {});
  ASSERT_TRUE(known.is_ok()) << known.status().message();
  EXPECT_EQ(known->scan.prepared.size(), 1u);
}

TEST_P(SharedLibraryTest, ADeletedScanIsGoneEverywhereAndDoesNotComeBackWithAServer) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(two_.store->open_mesh(two_.store->find("ball")->id, {5, 0}, {}).is_ok());
  one_.restart();  // away while the scan is deleted
  ASSERT_TRUE(two_.store->remove(ball.id).is_ok());
  EXPECT_EQ(shared_->file_count(), 0u);
  EXPECT_FALSE(fs::exists(own_folder(two_, ball)));
  share(one_, "one");
  EXPECT_TRUE(one_.store->list().empty());
  EXPECT_FALSE(fs::exists(own_folder(one_, ball)));
  EXPECT_TRUE(one_.import(sphere_file(), "ball").is_ok()) << "it may be imported again";
}

TEST_P(SharedLibraryTest, AScanThatComesAndGoesBetweenTwoReadsIsGone) {
  const int before = rows_.version;
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(two_.store->refresh().is_ok());
  ASSERT_TRUE(two_.store->remove(ball.id).is_ok());
  rows_.version = before;  // an empty catalogue is like another
  ASSERT_TRUE(one_.store->refresh().is_ok());
  EXPECT_TRUE(one_.store->list().empty());
}

TEST_P(SharedLibraryTest, AScanThatASessionOfAnyServerEditsStays) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  rows_.editing = "work";
  const Status refused = one_.store->remove(ball.id);
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("session work"));
  EXPECT_TRUE(fs::exists(own_folder(one_, ball)));
  EXPECT_EQ(shared_->original(ball), sphere_file());
}

TEST_P(SharedLibraryTest, AServerThatWasAloneSharesItsScans) {
  TestLibrary three;
  const ScanInfo cube = three.import(sphere_file(3), "cube")->scan;
  share(three, "three");
  EXPECT_EQ(shared_->original(cube), sphere_file(3));
  EXPECT_TRUE(one_.store->open_mesh(one_.store->find("cube")->id, {5, 0}, {}).is_ok());
}

TEST_P(SharedLibraryTest, ADamagedSharedOriginalIsNotUsedAndTheNextImportMakesItGood) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  damage(ball);
  ASSERT_TRUE(two_.store->refresh().is_ok());
  const Status refused = two_.store->open_mesh(ball.id, {5, 0}, {}).status();
  EXPECT_EQ(refused.code(), StatusCode::kDataLoss);
  EXPECT_THAT(refused.message(), HasSubstr("the original of scan ball in the " + shared_->name()));
  EXPECT_THAT(refused.message(), HasSubstr("is damaged or missing; import the same file again"));
  EXPECT_THAT(refused.message(), testing::Not(HasSubstr(shared_->place())));
  EXPECT_EQ(two_.store->import_known(ball.id, {5, 0}, {}).status().code(), StatusCode::kNotFound);
  ASSERT_TRUE(two_.import(sphere_file(), "ball").is_ok());
  EXPECT_EQ(shared_->original(ball), sphere_file());
  EXPECT_TRUE(two_.store->open_mesh(ball.id, {5, 0}, {}).is_ok());
}

TEST_P(SharedLibraryTest, ADamagedOwnOriginalIsFetchedAgain) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  fs::resize_file(own_folder(one_, ball) / "original.ply", 5);
  EXPECT_TRUE(one_.store->prepare_scan(ball.id, {4, 0}, {}).is_ok());
  EXPECT_EQ(content_of(own_folder(one_, ball) / "original.ply"), sphere_file());
}

TEST_P(SharedLibraryTest, AFailedImportIsNowhere) {
  const auto failed = one_.import("ply\nnonsense\n", "bad");
  EXPECT_FALSE(failed.is_ok());
  EXPECT_TRUE(rows_.scans.empty());
  EXPECT_EQ(shared_->unfinished() + shared_->file_count(), 0u);
}

TEST_P(SharedLibraryTest, ACancelledFetchLeavesNothing) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(two_.store->refresh().is_ok());
  const auto cancelled =
      two_.store->open_mesh(ball.id, {5, 0}, [](std::string_view, double) { return false; });
  EXPECT_EQ(cancelled.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(two_.staged_files(), 0u);
  EXPECT_FALSE(fs::exists(own_folder(two_, ball)));
}

TEST_P(SharedLibraryTest, AMissingOriginalIsLikeADamagedOne) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  shared_->clear();
  ASSERT_TRUE(two_.store->refresh().is_ok());
  EXPECT_EQ(two_.store->open_mesh(ball.id, {5, 0}, {}).status().code(), StatusCode::kDataLoss);
  ASSERT_TRUE(one_.import(sphere_file(), "ball").is_ok());
  EXPECT_TRUE(two_.store->open_mesh(ball.id, {5, 0}, {}).is_ok());
}

TEST_P(SharedLibraryTest, AShortOriginalIsReplacedByTheFirstImport) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  ASSERT_TRUE(one_.store->remove(ball.id).is_ok());
  shared_->put_original(ball, "half");
  ASSERT_TRUE(two_.import(sphere_file(), "ball").is_ok());
  EXPECT_EQ(shared_->original(ball), sphere_file());
}

TEST_P(SharedLibraryTest, InfoOfAScanIsBesideItsOriginal) {
  const ScanInfo ball = one_.import(sphere_file(), "ball")->scan;
  const auto info = scan_from_json(shared_->info(ball));
  ASSERT_TRUE(info.is_ok()) << info.status().message();
  EXPECT_EQ(info->name, "ball");
  EXPECT_EQ(shared_->file_count(), 2u);
}

TEST_P(SharedLibraryTest, TwoServersThatImportTheSameFileAtOnceHaveOneScan) {
  Status there = unavailable("not yet");
  std::jthread other([&] { there = two_.import(sphere_file(), "globe").status(); });
  const auto here = one_.import(sphere_file(), "ball");
  other.join();
  ASSERT_TRUE(here.is_ok()) << here.status().message();
  ASSERT_TRUE(there.is_ok()) << there.message();
  ASSERT_TRUE(one_.store->refresh().is_ok());
  EXPECT_EQ(one_.store->list().size(), 1u);
  EXPECT_EQ(shared_->original(here->scan), sphere_file());
  EXPECT_EQ(shared_->unfinished(), 0u);
  EXPECT_EQ(shared_->file_count(), 2u);
}

// Heartbeats take in what other servers did, and must not wait for a store that hangs.
TEST_P(SharedLibraryTest, AHeartbeatDoesNotWaitForAScanThatIsBeingShared) {
  Status heard = unavailable("not yet");
  rows_.on_placed = [&] {
    std::jthread([&] { heard = one_.store->refresh_unless_busy(); }).join();
  };
  ASSERT_TRUE(one_.import(sphere_file(), "ball").is_ok());
  EXPECT_TRUE(heard.is_ok());
  ASSERT_TRUE(two_.store->refresh_unless_busy().is_ok());
  EXPECT_EQ(two_.store->list().size(), 1u);
}

TEST(SharedFolder, AServersUnfinishedFilesGoAtItsStartAndNobodyElsesDo) {
  const TemporaryFolder folder;
  for (const char* name : {"one", "two"})
    fs::create_directories(folder / "staging" / name / "half");
  ASSERT_TRUE(SharedFolder::open(folder.path(), "one").is_ok());
  EXPECT_TRUE(fs::is_empty(folder / "staging/one"));
  EXPECT_TRUE(fs::exists(folder / "staging/two/half"));
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

#include "server/fleet/pg_catalogue.h"

#include <atomic>
#include <future>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/postgres_journal.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/postgres/postgres_cluster.h"

namespace burnish {
namespace {

using testing::HasSubstr;

Status nothing() {
  return Status::ok();
}

/// The catalogues of two servers, and the journal of one.
class PgCatalogueTest : public testing::Test {
 protected:
  PgCatalogueTest() {
    journal_->share_scans();
    scan_.id = std::string(64, 'a');
    scan_.name = "ball";
  }

  SessionRecord session_on(const std::string& scan_id) const {
    return {"id-w", "work", scan_id, {7, 0.5}, 1, {}};
  }
  std::vector<std::string> names(ScanCatalogue& catalogue) const {
    std::vector<std::string> names;
    const auto page = catalogue.read("");
    for (const ScanInfo& scan : (*page)->scans) names.push_back(scan.name);
    return names;
  }

  PostgresCluster cluster_{"fsync=off"};
  const TemporaryFolder folder_;
  const PgAddress address_ = PgAddress::parse(cluster_.make_database()).value();
  std::unique_ptr<PostgresJournal> journal_ =
      PostgresJournal::open(address_, folder_ / "paint.sqlite").value();
  std::unique_ptr<PgCatalogue> one_ = PgCatalogue::open(address_).value();
  std::unique_ptr<PgCatalogue> two_ = PgCatalogue::open(address_).value();
  ScanInfo scan_;
};

TEST_F(PgCatalogueTest, AScanOfOneServerIsReadByTheOtherAndOnlyWhenItIsNew) {
  const std::string empty = (*two_->read(""))->mark;
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  const auto page = two_->read(empty);
  ASSERT_TRUE(page.is_ok() && *page);
  EXPECT_EQ((*page)->scans[0].name, "ball");
  EXPECT_FALSE(two_->read((*page)->mark)->has_value());
  ASSERT_TRUE(one_->change(scan_.id, [](ScanInfo& scan) { scan.unit = "mm"; }).is_ok());
  EXPECT_EQ((*two_->read((*page)->mark))->scans[0].unit, "mm");
}

TEST_F(PgCatalogueTest, TheFirstEntryOfAScanCounts) {
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  scan_.name = "globe";
  EXPECT_EQ(two_->enter(scan_, nothing)->name, "ball");
}

TEST_F(PgCatalogueTest, TwoServersDoNotGiveOneNameAtTheSameMoment) {
  ScanInfo other = scan_;
  other.id = std::string(64, 'b');
  other.name = "BALL";  // it looks like "ball"
  Status meanwhile;
  ASSERT_TRUE(one_->enter(scan_,
                          [&] {
                            meanwhile = two_->enter(other, nothing).status();
                            return Status::ok();
                          })
                  .is_ok());
  EXPECT_EQ(meanwhile.code(), StatusCode::kAlreadyExists);
  const Status later = two_->enter(other, nothing).status();
  EXPECT_EQ(later.code(), StatusCode::kAlreadyExists);
  EXPECT_THAT(later.message(), HasSubstr("'ball', scan aaaaaaaa"));
  EXPECT_EQ(names(*one_), std::vector<std::string>{"ball"});
}

TEST_F(PgCatalogueTest, ANameIsFreeAgainWhenItsScanWasNotEntered) {
  const auto failed = one_->enter(scan_, [] { return resource_exhausted("no space"); });
  ASSERT_FALSE(failed.is_ok());
  scan_.id = std::string(64, 'b');
  EXPECT_TRUE(two_->enter(scan_, nothing).is_ok());
}

TEST_F(PgCatalogueTest, AScanIsNotRenamedToANameThatAnotherServerHasGiven) {
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  ScanInfo other = scan_;
  other.id = std::string(64, 'b');
  other.name = "globe";
  ASSERT_TRUE(two_->enter(other, nothing).is_ok());
  const auto rename = [](ScanInfo& scan) { scan.name = "Ball"; };
  EXPECT_EQ(two_->change(other.id, rename).status().code(), StatusCode::kAlreadyExists);
  EXPECT_THAT(names(*one_), testing::UnorderedElementsAre("ball", "globe"));
  EXPECT_TRUE(two_->change(scan_.id, rename).is_ok()) << "its own name in another way";
}

TEST_F(PgCatalogueTest, AScanWhoseFilesFailIsNotEntered) {
  const auto failed = one_->enter(scan_, [] { return resource_exhausted("no space"); });
  EXPECT_EQ(failed.status().code(), StatusCode::kResourceExhausted);
  EXPECT_TRUE(names(*two_).empty());
}

TEST_F(PgCatalogueTest, AScanThatASessionEditsStaysWithItsFiles) {
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  ASSERT_TRUE(journal_->create_session(session_on(scan_.id), {}).is_ok());
  bool has_removed = false;
  const auto remove_files = [&] {
    has_removed = true;
    return Status::ok();
  };
  const Status refused = two_->remove(scan_.id, remove_files);
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("session work"));
  EXPECT_FALSE(has_removed);
  ASSERT_TRUE(journal_->remove_session("id-w").is_ok());
  EXPECT_TRUE(two_->remove(scan_.id, remove_files).is_ok());
  EXPECT_TRUE(has_removed);
  EXPECT_TRUE(names(*one_).empty());
}

TEST_F(PgCatalogueTest, NoSessionIsMadeOnADeletedScan) {
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  ASSERT_TRUE(two_->remove(scan_.id, nothing).is_ok());
  const Status refused = journal_->create_session(session_on(scan_.id), {});
  EXPECT_EQ(refused.code(), StatusCode::kNotFound);
  EXPECT_TRUE(journal_->sessions()->empty());
}

TEST_F(PgCatalogueTest, ASessionThatIsMadeWhileItsScanGoesIsRefused) {
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  std::future<Status> made;
  ASSERT_TRUE(two_->remove(scan_.id,
                           [&] {
                             made = std::async(std::launch::async, [&] {
                               return journal_->create_session(session_on(scan_.id), {});
                             });
                             return Status::ok();
                           })
                  .is_ok());
  EXPECT_EQ(made.get().code(), StatusCode::kNotFound);
}

TEST_F(PgCatalogueTest, SessionsFromBeforeTheCatalogueHoldTheirScansToo) {
  const auto old = PostgresJournal::open(address_, folder_ / "old.sqlite").value();
  ASSERT_TRUE(old->create_session(session_on(scan_.id), {}).is_ok());
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  EXPECT_EQ(one_->remove(scan_.id, nothing).code(), StatusCode::kFailedPrecondition);
}

TEST_F(PgCatalogueTest, ItIsReadAgainAfterTheDatabaseWasKilled) {
  ASSERT_TRUE(one_->enter(scan_, nothing).is_ok());
  cluster_.kill();
  cluster_.start();
  EXPECT_EQ(names(*one_), std::vector<std::string>{"ball"});
}

}  // namespace
}  // namespace burnish

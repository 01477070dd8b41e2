// Damage to a scan's files is found before they are used, and an import repairs it.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/library/scan_record.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class ScanDamageTest : public testing::Test {
 protected:
  ScanDamageTest() : scan_(library_.import(bytes_, "ball").value().scan) {}

  fs::path file(const std::string& name) const {
    return library_.folder->scans() / scan_.id / name;
  }
  fs::path prepared() const { return file("prepared") / prepared_file_name({5, 0}); }

  void flip_a_bit_of_the_original() {
    std::string bad = bytes_;
    bad[bad.size() - 100] ^= 1;
    std::ofstream(file("original.ply"), std::ios::binary) << bad;
  }

  const std::string bytes_ = sphere_file();
  TestLibrary library_;
  const ScanInfo scan_;
};

TEST_F(ScanDamageTest, ADamagedOriginalIsNotPrepared) {
  flip_a_bit_of_the_original();
  EXPECT_TRUE(library_.store->open_mesh(scan_.id, {5, 0}, {}).is_ok());  // as it was before
  fs::remove(prepared());
  const Status status = library_.store->open_mesh(scan_.id, {5, 0}, {}).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_THAT(status.message(), HasSubstr("original.ply"));
  EXPECT_THAT(status.message(), HasSubstr("import the same file again"));
  fs::remove(file("original.ply"));
  EXPECT_EQ(library_.store->prepare_scan(scan_.id, {5, 0}, {}).code(), StatusCode::kDataLoss);
}

TEST_F(ScanDamageTest, AnImportOfTheSameFileReplacesADamagedOriginal) {
  flip_a_bit_of_the_original();
  EXPECT_EQ(library_.store->import_known(scan_.id, {5, 0}, {}).status().code(),
            StatusCode::kNotFound);
  const auto outcome = library_.import(bytes_, "again");
  ASSERT_TRUE(outcome.is_ok()) << outcome.status().message();
  EXPECT_TRUE(outcome->already_present);
  EXPECT_EQ(outcome->scan.name, "ball");
  EXPECT_EQ(content_of(file("original.ply")), bytes_);
  EXPECT_TRUE(library_.store->import_known(scan_.id, {5, 0}, {}).is_ok());
}

TEST_F(ScanDamageTest, WhatWasPreparedFromADamagedOriginalIsMadeAgain) {
  flip_a_bit_of_the_original();
  const std::string good = content_of(prepared());
  fs::copy(prepared(), file("prepared") / prepared_file_name({6, 0}));
  ASSERT_TRUE(library_.import(bytes_, "ball").is_ok());
  EXPECT_FALSE(fs::exists(file("prepared") / prepared_file_name({6, 0})));
  EXPECT_EQ(content_of(prepared()), good);
}

TEST_F(ScanDamageTest, AnImportOfTheSameFileReplacesADamagedInfo) {
  ASSERT_TRUE(library_.store->prepare_scan(scan_.id, {6, 0}, {}).is_ok());
  fs::resize_file(file("info.json"), 20);
  library_.restart();
  EXPECT_TRUE(library_.store->list().empty());
  EXPECT_EQ(library_.store->import_known(scan_.id, {5, 0}, {}).status().code(),
            StatusCode::kNotFound);
  const auto outcome = library_.import(bytes_, "again");
  ASSERT_TRUE(outcome.is_ok()) << outcome.status().message();
  EXPECT_EQ(outcome->scan.name, "again");
  EXPECT_EQ(outcome->scan.prepared.size(), 2u);
  EXPECT_EQ(library_.store->list().size(), 1u);
  EXPECT_EQ(library_.staged_files(), 0u);
}

TEST_F(ScanDamageTest, AFolderThatIsNoScanAnyMoreCanBeRemoved) {
  fs::remove(file("info.json"));
  EXPECT_TRUE(library_.store->remove(scan_.id).is_ok());
  EXPECT_EQ(library_.store->remove(scan_.id).code(), StatusCode::kNotFound);
  EXPECT_EQ(library_.store->remove("..").code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish

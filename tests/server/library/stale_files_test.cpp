#include "server/library/stale_files.h"

#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/library/scan_record.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

/// A library with one scan, and further files in the folder of its prepared file.
class StaleFiles : public testing::Test {
 protected:
  StaleFiles() {
    scan_ = library_.import(sphere_file(), "ball").value().scan;
    prepared_ = library_.folder->scans() / scan_.id / "prepared";
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(prepared_ / name) << text;
  }
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(prepared_))
      found.insert(entry.path().filename().string());
    return found;
  }

  TestLibrary library_;
  ScanInfo scan_;
  fs::path prepared_;
  std::string current_ = prepared_file_name({5, 0});
};

TEST_F(StaleFiles, OfOtherVersionsAndHalfWrittenOnesGo) {
  write("depth5-radius0-format1.prepared", "burnish\n12");
  write("depth9-radius0.10000000000000001-format999.prepared", "burnish\n");
  write(current_ + ".4711-3.tmp", "");
  write(current_ + ".4711-4.tmp", "burnish\n");
  const RemovedFiles removed = remove_stale_files(*library_.folder);
  EXPECT_EQ(removed.count, 4u);
  EXPECT_EQ(removed.bytes, 10u + 8 + 8);
  EXPECT_THAT(names(), testing::ElementsAre(current_));
  EXPECT_TRUE(library_.store->open_mesh(scan_.id, {5, 0}, {}).is_ok());
}

TEST_F(StaleFiles, PagesOfOtherVersionsAndHalfWrittenOnesGo) {
  const fs::path folder = prepared_.parent_path();
  const auto write_page_file = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
  };
  write_page_file("pages-format999.pages", "BnPg12");
  write_page_file(pages_file_name() + ".4711-3.tmp", "BnPg");
  write_page_file("pages-format998.pages", "something else");
  write_page_file("pages-format1-texels1.pages", "BnPg1");
  write_page_file(pages_file_name(true), "BnPg1");
  const RemovedFiles removed = remove_stale_files(*library_.folder);
  EXPECT_EQ(removed.count, 3u);
  EXPECT_EQ(removed.bytes, 15u);
  EXPECT_TRUE(fs::exists(folder / pages_file_name()));
  EXPECT_TRUE(fs::exists(folder / pages_file_name(true)));
  EXPECT_TRUE(fs::exists(folder / "pages-format998.pages"));
}

TEST_F(StaleFiles, WhatNoServerWroteStays) {
  write("depth5-radius0-format1.prepared", "something else");
  write("depth05-radius0-format1.prepared", "burnish\n");
  write("depth5-radius0-format1.prepared.bak", "burnish\n");
  write("depth5-radius0-format1.prepared.mine.tmp", "burnish\n");
  write("notes.txt", "burnish\n");
  const fs::path elsewhere = library_.root / "elsewhere";
  std::ofstream(elsewhere) << "burnish\n";
  fs::create_symlink(elsewhere, prepared_ / "depth6-radius0-format1.prepared");
  fs::create_directories(library_.folder->scans() / "mine/prepared");
  std::ofstream(library_.folder->scans() / "mine/prepared/depth5-radius0-format1.prepared")
      << "burnish\n";
  const auto before = names();
  EXPECT_EQ(remove_stale_files(*library_.folder).count, 0u);
  EXPECT_EQ(names(), before);
  EXPECT_TRUE(fs::exists(elsewhere));
  EXPECT_TRUE(
      fs::exists(library_.folder->scans() / "mine/prepared/depth5-radius0-format1.prepared"));
}

}  // namespace
}  // namespace burnish

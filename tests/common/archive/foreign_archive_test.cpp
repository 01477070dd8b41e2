// Archives as other programs write them.

#include <gmock/gmock.h>

#include "common/archive/archive.h"
#include "tests/common/archive/packing.h"
#include "tests/common/archive/zip_text.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Returns the names, or why the archive is refused.
std::vector<std::string> names_in(const ZipText& zip) {
  const auto bytes = zip.bytes();
  const auto archive = Archive::open(bytes, "scan.zip");
  if (!archive.is_ok()) return {archive.status().message()};
  std::vector<std::string> names;
  for (const ArchiveEntry& entry : archive->entries()) names.push_back(entry.name);
  return names;
}

TEST(ForeignArchive, SizesBehindAnEntryAreRead) {
  for (const bool is_zip64 : {false, true})
    for (const LocalSizes sizes :
         {LocalSizes::kAll, LocalSizes::kNone, LocalSizes::kUnpackedAlone}) {
      ZipText zip;
      zip.sizes = sizes;
      zip.is_zip64 = is_zip64;
      zip.add("scan/scan.obj", "v 0 0 0\n");
      zip.add("scan/scan.mtl", "newmtl a\n");
      const auto bytes = zip.bytes();
      const auto archive = Archive::open(bytes, "scan.zip");
      ASSERT_TRUE(archive.is_ok()) << archive.status().message();
      EXPECT_EQ(as_string(archive->read(0).value()), "v 0 0 0\n");
      EXPECT_EQ(as_string(archive->read(1).value()), "newmtl a\n");
      const std::string moved = "v 1 0 0\n";
      const ChangedEntry changed = {0, as_bytes(moved)};
      const auto replaced = replace_entries(bytes, {&changed, 1});
      ASSERT_TRUE(replaced.is_ok()) << replaced.status().message();
      const auto again = Archive::open(*replaced, "scan.zip");
      ASSERT_TRUE(again.is_ok()) << again.status().message();
      EXPECT_EQ(as_string(again->read(0).value()), moved);
      EXPECT_EQ(as_string(again->read(1).value()), "newmtl a\n");
    }
}

TEST(ForeignArchive, AHeaderThatSaysSomethingElseIsRefused) {
  ZipText zip;
  zip.add("scan.obj", "v 0 0 0\n");
  const auto bytes = zip.bytes();
  constexpr size_t kMethod = 8, kSum = 14, kPacked = 18, kUnpacked = 22, kName = 30;
  for (const size_t at : {size_t{0}, kMethod, kSum, kPacked, kUnpacked, kName}) {
    auto other = bytes;
    other[at] ^= 2;
    const auto archive = Archive::open(other, "scan.zip");
    EXPECT_EQ(archive.status().code(), StatusCode::kInvalidArgument) << at;
    EXPECT_THAT(archive.status().message(), HasSubstr("'scan.obj'")) << at;
  }
  EXPECT_TRUE(Archive::open(bytes, "scan.zip").is_ok());
}

TEST(ForeignArchive, ADotBeforeANameIsTheFolder) {
  ZipText zip;
  zip.add("./", "");
  zip.add("./scan.obj", "v");
  zip.add("maps/./skin.png", "w");
  EXPECT_THAT(names_in(zip), testing::ElementsAre("./", "scan.obj", "maps/skin.png"));
  zip.add("scan.obj", "other");
  EXPECT_THAT(names_in(zip)[0], HasSubstr("twice"));
  ZipText outside;
  outside.add("./../scan.obj", "v");
  EXPECT_THAT(names_in(outside)[0], HasSubstr("'..'"));
}

TEST(ForeignArchive, BackslashesOfWindowsSeparateParts) {
  ZipText zip;
  zip.system = 0;
  zip.add("maps\\", "");
  zip.add("maps\\skin.png", "w");
  EXPECT_THAT(names_in(zip), testing::ElementsAre("maps/", "maps/skin.png"));
  zip.add("..\\scan.obj", "v");
  EXPECT_THAT(names_in(zip)[0], HasSubstr("'..'"));
  ZipText of_unix;
  of_unix.add("maps\\skin.png", "w");
  EXPECT_THAT(names_in(of_unix)[0], HasSubstr("'maps\\skin.png' has a '\\'"));
}

}  // namespace
}  // namespace burnish

#include "common/archive/archive_writer.h"

#include <gmock/gmock.h>

#include "common/archive/archive.h"
#include "tests/common/archive/packing.h"

namespace burnish {
namespace {

TEST(ArchiveWriter, SameFilesGiveSameBytes) {
  const NamedTexts files = {{"scan.obj", "v 0 0 0\n"}, {"skin.png", "pixels"}};
  EXPECT_EQ(packed(files), packed(files));
}

TEST(ArchiveWriter, CompressedFilesAreStoredAsTheyAre) {
  const std::string text(1000, 'x');
  EXPECT_NE(as_string(packed({{"skin.PNG", text}})).find(text), std::string::npos);
  EXPECT_LT(packed({{"scan.obj", text}}).size(), text.size());
}

TEST(ArchiveWriter, NamesThatLeadElsewhereAreRefused) {
  const FileToPack file = {"../scan.obj", {}};
  EXPECT_EQ(pack_archive({&file, 1}).status().code(), StatusCode::kInvalidArgument);
}

TEST(ArchiveWriter, OneReplacedEntryLeavesTheOthersAlone) {
  const auto bytes = packed({{"a.mtl", "newmtl a"}, {"scan.obj", "v 0 0 0"}, {"b.png", "pixels"}});
  const std::string longer(5000, '7');
  const auto replaced = replace_entry(bytes, 1, as_bytes(longer));
  ASSERT_TRUE(replaced.is_ok()) << replaced.status().message();
  const Archive archive = std::move(Archive::open(*replaced, "scan.zip")).value();
  ASSERT_EQ(archive.entries().size(), 3u);
  EXPECT_EQ(archive.entries()[1].name, "scan.obj");
  EXPECT_EQ(as_string(archive.read(0).value()), "newmtl a");
  EXPECT_EQ(as_string(archive.read(1).value()), longer);
  EXPECT_EQ(as_string(archive.read(2).value()), "pixels");
  EXPECT_EQ(*replace_entry(*replaced, 1, as_bytes("v 0 0 0")), bytes);
}

}  // namespace
}  // namespace burnish

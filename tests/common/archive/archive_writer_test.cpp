#include "common/archive/archive_writer.h"

#include <gmock/gmock.h>

#include "common/archive/archive.h"
#include "tests/common/archive/packing.h"

namespace burnish {
namespace {

Result<std::vector<uint8_t>> with_entry(const std::vector<uint8_t>& archive, size_t entry,
                                        const std::string& text) {
  const ChangedEntry changed = {entry, as_bytes(text)};
  return replace_entries(archive, {&changed, 1});
}

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
  for (const size_t entry : {1, 2}) {
    const auto replaced = with_entry(bytes, entry, longer);
    ASSERT_TRUE(replaced.is_ok()) << replaced.status().message();
    const Archive archive = std::move(Archive::open(*replaced, "scan.zip")).value();
    const Archive before = std::move(Archive::open(bytes, "scan.zip")).value();
    ASSERT_EQ(archive.entries().size(), 3u);
    for (size_t e = 0; e < 3; ++e) {
      EXPECT_EQ(archive.entries()[e].name, before.entries()[e].name);
      EXPECT_EQ(as_string(archive.read(e).value()),
                e == entry ? longer : as_string(before.read(e).value()));
    }
  }
}

TEST(ArchiveWriter, AnEntryThatIsReplacedKeepsItsTimeAndItsPacking) {
  const auto bytes = packed({{"scan.obj", "v 0 0 0"}, {"b.png", "pixels"}});
  for (const size_t entry : {0, 1}) {
    const auto other = with_entry(bytes, entry, std::string(5000, '7')).value();
    const std::string old = entry == 0 ? "v 0 0 0" : "pixels";
    EXPECT_EQ(with_entry(other, entry, old).value(), bytes) << entry;
  }
}

}  // namespace
}  // namespace burnish

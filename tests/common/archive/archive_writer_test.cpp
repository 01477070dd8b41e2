#include "common/archive/archive_writer.h"

#include <random>

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

/// Files in a random order: some can be packed well, others cannot.
NamedTexts random_files(std::mt19937& random) {
  const auto below = [&](unsigned bound) { return static_cast<unsigned>(random() % bound); };
  NamedTexts files;
  const unsigned count = 1 + below(8);
  for (unsigned f = 0; f < count; ++f) {
    std::string text(below(4) == 0 ? below(10) : below(200'000), 'v');
    if (below(2) == 0)
      for (char& letter : text) letter = static_cast<char>(random());
    const char* extensions[] = {".obj", ".mtl", ".png", ".bin"};
    files.emplace_back(std::to_string(f) + extensions[below(4)], std::move(text));
  }
  return files;
}

TEST(ArchiveWriter, AnyEntriesOfAnyOrderAndSizeAreReplaced) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    NamedTexts files = random_files(random);
    const auto before = packed(files);
    const NamedTexts others = random_files(random);
    std::vector<ChangedEntry> changed;
    for (size_t e = 0; e < files.size(); ++e) {
      if (random() % 3 == 0 || (changed.empty() && e + 1 == files.size())) {
        files[e].second = others[random() % others.size()].second;
        changed.push_back({e, as_bytes(files[e].second)});
      }
    }
    const auto after = replace_entries(before, changed);
    ASSERT_TRUE(after.is_ok()) << seed << ": " << after.status().message();
    const Archive archive = std::move(Archive::open(*after, "scan.zip")).value();
    ASSERT_EQ(archive.entries().size(), files.size()) << seed;
    for (size_t e = 0; e < files.size(); ++e) {
      EXPECT_EQ(archive.entries()[e].name, files[e].first) << seed;
      EXPECT_TRUE(as_string(archive.read(e).value()) == files[e].second) << seed << ", entry " << e;
    }
  }
}

TEST(ArchiveWriter, EntriesThatStayKeepTheirPackedBytes) {
  const std::string skin = "not a picture, and not packed";
  const auto before =
      packed({{"skin.png", skin}, {"a.mtl", std::string(3000, 'm')}, {"s.obj", "v"}});
  const auto after = with_entry(before, 2, "other").value();
  constexpr size_t kHeaderBytes = 30;
  const size_t unchanged = as_string(before).find("s.obj") - kHeaderBytes;
  EXPECT_EQ(as_string(after).substr(0, unchanged), as_string(before).substr(0, unchanged));
  EXPECT_THAT(as_string(after), testing::HasSubstr(skin));
}

}  // namespace
}  // namespace burnish

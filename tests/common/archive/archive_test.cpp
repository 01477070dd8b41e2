#include "common/archive/archive.h"

#include <gmock/gmock.h>

#include "tests/common/archive/packing.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::string refusal_of(const std::vector<uint8_t>& bytes) {
  const auto archive = Archive::open(bytes, "scan.zip");
  EXPECT_EQ(archive.status().code(), StatusCode::kInvalidArgument);
  return archive.status().message();
}

/// Sets a number in the central directory's first record, at an offset that the format gives.
std::vector<uint8_t> with_directory_byte(std::vector<uint8_t> bytes, size_t offset, uint8_t value) {
  const size_t record = as_string(bytes).find("PK\x01\x02");
  bytes[record + offset] = value;
  return bytes;
}

TEST(Archive, EntriesComeInTheirOrderWithTheirBytes) {
  const auto bytes = packed({{"b/scan.obj", "v 0 0 0\n"}, {"a.mtl", ""}, {"skin.png", "pixels"}});
  const Archive archive = std::move(Archive::open(bytes, "scan.zip")).value();
  ASSERT_EQ(archive.entries().size(), 3u);
  EXPECT_EQ(archive.entries()[0].name, "b/scan.obj");
  EXPECT_EQ(archive.entries()[0].size_bytes, 8u);
  EXPECT_EQ(as_string(archive.read(0).value()), "v 0 0 0\n");
  EXPECT_EQ(as_string(archive.read(1).value()), "");
  EXPECT_EQ(as_string(archive.read(2).value()), "pixels");
  EXPECT_EQ(archive.find("skin.png"), 2u);
  EXPECT_FALSE(archive.find("Skin.png").has_value());
}

TEST(Archive, EntriesThatLeadElsewhereAreRefused) {
  const auto bytes = packed({{"aa/scan.obj", "v"}});
  EXPECT_THAT(refusal_of(patched(bytes, "aa/", "../")), HasSubstr("'../scan.obj'"));
  EXPECT_THAT(refusal_of(patched(bytes, "aa/", "/a/")), HasSubstr("absolute"));
  EXPECT_THAT(refusal_of(patched(bytes, "aa/", "C:/")), HasSubstr("drive"));
  EXPECT_THAT(refusal_of(patched(bytes, "aa/", "aa\\")), HasSubstr("'\\'"));
}

TEST(Archive, LinksAndDevicesAreRefused) {
  const auto bytes = packed({{"scan.obj", "/etc/passwd"}});
  constexpr size_t kSystem = 5, kAttributesTop = 41;
  const auto by_unix = with_directory_byte(bytes, kSystem, 3);
  EXPECT_TRUE(Archive::open(with_directory_byte(by_unix, kAttributesTop, 0x81), "").is_ok());
  EXPECT_THAT(refusal_of(with_directory_byte(by_unix, kAttributesTop, 0xa1)), HasSubstr("link"));
  EXPECT_THAT(refusal_of(with_directory_byte(by_unix, kAttributesTop, 0x21)), HasSubstr("device"));
}

TEST(Archive, TwoEntriesOfOneNameAreRefused) {
  const auto bytes = packed({{"one.obj", "v"}, {"two.obj", "w"}});
  EXPECT_THAT(refusal_of(patched(bytes, "two", "one")), HasSubstr("'one.obj'"));
  const auto folder = packed({{"one/a", "v"}, {"one/b", "w"}});
  EXPECT_THAT(refusal_of(patched(folder, "one/b", "one/a")), HasSubstr("twice"));
}

TEST(Archive, EncryptedEntriesAreRefused) {
  auto bytes = packed({{"scan.obj", "v"}});
  bytes[6] |= 1;  // the flags of the first local header
  EXPECT_THAT(refusal_of(with_directory_byte(bytes, 8, bytes[6])), HasSubstr("encrypted"));
}

TEST(Archive, AHeaderWhoseFieldIsCutOffIsRefused) {
  constexpr size_t kFieldsLength = 28;
  auto bytes = packed({{"in/", ""}, {"in/scan.obj", "v"}});
  bytes[kFieldsLength] = 4;  // those are the beginning of the next header
  EXPECT_THAT(refusal_of(bytes), HasSubstr("entry 'in/': the archive is damaged: a field"));
}

TEST(Archive, UnpackedBytesBeyondTheRatioAreRefused) {
  const std::string zeros(4 << 20, '\0');
  const auto bytes = packed({{"zeros.obj", zeros}});
  const std::string why = refusal_of(bytes);
  EXPECT_THAT(why, HasSubstr("zeros.obj"));
  EXPECT_THAT(why, HasSubstr(std::to_string(zeros.size())));
  EXPECT_THAT(why, HasSubstr(std::to_string(std::max<size_t>(1 << 20, 100 * bytes.size()))));
}

TEST(Archive, TheSumOfAllEntriesCounts) {
  const std::string zeros(900'000, '\0');
  EXPECT_TRUE(Archive::open(packed({{"a", zeros}}), "").is_ok());
  EXPECT_THAT(refusal_of(packed({{"a", zeros}, {"b", zeros}})), HasSubstr("'b'"));
}

TEST(Archive, TooManyEntriesAreRefused) {
  NamedTexts files;
  for (int i = 0; i < 10'001; ++i) files.emplace_back(std::to_string(i), "");
  const std::string why = refusal_of(packed(files));
  EXPECT_THAT(why, HasSubstr("10001"));
  EXPECT_THAT(why, HasSubstr("10000"));
}

TEST(Archive, CutFilesAreRefused) {
  const auto bytes = packed({{"scan.obj", "v 0 0 0\n"}, {"a.mtl", "newmtl a\n"}});
  for (size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(Archive::open({bytes.data(), length}, "scan.zip").is_ok()) << length;
}

TEST(Archive, ADamagedEntryIsNamed) {
  const auto bytes = patched(packed({{"skin.png", "pixels"}}), "pixels", "pixelz");
  const auto content = Archive::open(bytes, "scan.zip").value().read(0);
  EXPECT_THAT(content.status().message(), HasSubstr("scan.zip: entry 'skin.png'"));
}

}  // namespace
}  // namespace burnish

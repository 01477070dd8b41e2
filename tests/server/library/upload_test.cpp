#include "server/library/upload.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/transfer/chunk.h"
#include "tests/common/base/file_size_limit.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

Status append(Upload& upload, uint64_t offset, const std::string& data) {
  return upload.append(offset, data, chunk_crc32(data));
}

TEST(Upload, ChunksInOrderGiveTheFileAndItsHash) {
  const TemporaryFolder folder;
  const auto upload = std::move(Upload::create(folder / "u", 3)).value();
  ASSERT_TRUE(append(*upload, 0, "a").is_ok());
  ASSERT_TRUE(append(*upload, 1, "bc").is_ok());
  EXPECT_EQ(upload->finish().value(),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(content_of(folder / "u"), "abc");
}

TEST(Upload, MoreOrFewerBytesThanAnnouncedAreRefused) {
  const TemporaryFolder folder;
  const auto upload = std::move(Upload::create(folder / "u", 3)).value();
  ASSERT_TRUE(append(*upload, 0, "ab").is_ok());
  EXPECT_THAT(append(*upload, 2, "cd").message(), HasSubstr("announced 3 bytes"));
  EXPECT_THAT(upload->finish().status().message(), HasSubstr("after 2 of 3 bytes"));
}

TEST(Upload, LeavesNothingBehindUnlessMoved) {
  const TemporaryFolder folder;
  {
    const auto upload = std::move(Upload::create(folder / "u", 3)).value();
    ASSERT_TRUE(append(*upload, 0, "abc").is_ok());
  }
  EXPECT_EQ(folder.file_count(), 0u);
}

TEST(Upload, AFullDiskIsResourceExhausted) {
  const TemporaryFolder folder;
  const FileSizeLimit limit(4096);
  const auto upload = std::move(Upload::create(folder / "u", 100'000)).value();
  EXPECT_EQ(append(*upload, 0, std::string(100'000, 'x')).code(), StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace burnish

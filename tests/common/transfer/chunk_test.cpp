#include "common/transfer/chunk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/transfer/content_hash.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(Chunk, CrcIsThatOfZlib) {
  EXPECT_EQ(chunk_crc32("123456789"), 0xcbf43926u);
}

TEST(Chunk, AGapIsDataLoss) {
  const Status status = check_chunk(10, 20, "abc", chunk_crc32("abc"));
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_THAT(status.message(), HasSubstr("offset 20 should begin at 10"));
}

TEST(Chunk, DamagedBytesAreDataLoss) {
  EXPECT_EQ(check_chunk(0, 0, "abd", chunk_crc32("abc")).code(), StatusCode::kDataLoss);
}

TEST(Chunk, EmptyAndOversizedChunksAreRefused) {
  EXPECT_EQ(check_chunk(0, 0, "", 0).code(), StatusCode::kInvalidArgument);
  const std::string large(kChunkBytesMax + 1, 'x');
  EXPECT_EQ(check_chunk(0, 0, large, chunk_crc32(large)).code(), StatusCode::kInvalidArgument);
}

TEST(ContentHash, IsSha256) {
  ContentHash hash;
  hash.update("a");
  hash.update("bc");
  EXPECT_EQ(hash.finish(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ContentHash, NamesOfOtherThingsAreNoHashes) {
  EXPECT_TRUE(is_content_hash(std::string(64, '0')));
  EXPECT_FALSE(is_content_hash(std::string(63, '0')));
  EXPECT_FALSE(is_content_hash(std::string(64, 'G')));
}

}  // namespace
}  // namespace burnish

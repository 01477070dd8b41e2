#include "client/publish/parts_writer.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::EndsWith;

PartsFiles written(const TemporaryFolder& folder, const std::vector<std::string>& parts) {
  auto writer = PartsWriter::create(folder.path());
  EXPECT_TRUE(writer.is_ok()) << writer.status().message();
  for (const std::string& part : parts) EXPECT_TRUE(writer->add(part).is_ok());
  const auto files = writer->finish();
  EXPECT_TRUE(files.is_ok()) << files.status().message();
  return *files;
}

std::vector<uint32_t> numbers_in(const std::string& bytes) {
  std::vector<uint32_t> numbers(bytes.size() / sizeof(uint32_t));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

TEST(PartsWriterFiles, HaveThePartsOneBehindTheOtherAndTheirLengths) {
  const TemporaryFolder folder;
  const PartsFiles files = written(folder, {"page", "", "a tile", std::string(300, 'x')});
  EXPECT_EQ(content_of(folder / files.parts), "pagea tile" + std::string(300, 'x'));
  EXPECT_THAT(numbers_in(content_of(folder / files.index)), ElementsAre(4, 0, 6, 300));
  EXPECT_EQ(folder.file_count(), 2U);
}

TEST(PartsWriterFiles, AreNamedByTheirContent) {
  const TemporaryFolder folder;
  const PartsFiles one = written(folder, {"ab", "c"});
  EXPECT_THAT(one.parts, EndsWith(".parts"));
  EXPECT_NE(one.parts, written(folder, {"a", "bc"}).parts);  // other lengths of the same bytes
  EXPECT_EQ(one.parts, written(folder, {"ab", "c"}).parts);
}

TEST(PartsWriterFiles, AreGoneWithAWriterThatDoesNotFinish) {
  const TemporaryFolder folder;
  {
    auto writer = PartsWriter::create(folder.path());
    ASSERT_TRUE(writer->add("page").is_ok());
  }
  EXPECT_EQ(folder.file_count(), 0U);
}

}  // namespace
}  // namespace burnish

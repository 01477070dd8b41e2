#include <atomic>
#include <fcntl.h>
#include <future>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/lease/held_file.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const std::string& content() {
  static const std::string bytes = [] {
    std::string made;
    for (int i = 0; i < 400'000; ++i) made += static_cast<char>(i * 31 >> 3);
    return made;
  }();
  return bytes;
}

template <typename File>
std::string text_of(const File& file) {
  return {file.bytes().begin(), file.bytes().end()};
}

LeasedFile lease(const fs::path& path) {
  return LeasedFile::open(path, path.parent_path()).value();
}

/// A folder on a file system with leases.
class ALeasedFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto trial = LeasedFile::open(folder.write("trial", "x"), folder.path());
    if (!trial.is_ok()) GTEST_SKIP() << trial.status().to_string();
  }

  TemporaryFolder folder;
};

TEST_F(ALeasedFile, IsTheFilesBytes) {
  EXPECT_EQ(text_of(lease(folder.write("a", content()))), content());
}

TEST_F(ALeasedFile, StaysWhenTheFileIsCut) {
  const fs::path path = folder.write("a", content());
  const LeasedFile file = lease(path);
  const uint8_t* const before = file.bytes().data();
  fs::resize_file(path, 0);
  EXPECT_EQ(text_of(file), content());
  EXPECT_EQ(file.bytes().data(), before);
  EXPECT_EQ(fs::file_size(path), 0u);
}

TEST_F(ALeasedFile, StaysWhenTheFileIsWrittenTo) {
  const fs::path path = folder.write("a", content());
  const LeasedFile file = lease(path);
  folder.write("a", "other words");
  EXPECT_EQ(text_of(file), content());
  EXPECT_EQ(content_of(path), "other words");
}

TEST_F(ALeasedFile, StaysWhenTheFileIsReplacedOrRemoved) {
  const fs::path path = folder.write("a", content());
  const LeasedFile file = lease(path);
  fs::rename(folder.write("b", "other words"), path);
  EXPECT_EQ(text_of(file), content());
  fs::remove(path);
  EXPECT_EQ(text_of(file), content());
}

TEST_F(ALeasedFile, StaysInMemoryWhereTheFolderTakesNoCopy) {
  const fs::path path = folder.write("a", content());
  const LeasedFile file = LeasedFile::open(path, folder / "missing").value();
  fs::resize_file(path, 0);
  EXPECT_EQ(text_of(file), content());
}

TEST_F(ALeasedFile, IsReadByOthersMeanwhile) {
  const fs::path path = folder.write("a", content());
  const LeasedFile one = lease(path), two = lease(path);
  EXPECT_EQ(content_of(path), content());
  fs::resize_file(path, 1);
  EXPECT_EQ(text_of(one), content());
  EXPECT_EQ(text_of(two), content());
}

TEST_F(ALeasedFile, LosesNoByteWhileItIsReadAndCut) {
  const fs::path path = folder.write("a", content());
  const LeasedFile file = lease(path);
  std::atomic<bool> is_cut = false;
  auto reader = std::async(std::launch::async, [&] {
    int wrong = 0;
    do wrong += text_of(file) != content();
    while (!is_cut);
    return wrong;
  });
  fs::resize_file(path, 0);
  is_cut = true;
  EXPECT_EQ(reader.get(), 0);
}

TEST_F(ALeasedFile, LetsGoOfTheFileAtItsEnd) {
  const fs::path path = folder.write("a", content());
  {
    LeasedFile file = lease(path);
    file = lease(folder.write("b", "x"));
  }
  fs::resize_file(path, 3);
  EXPECT_EQ(content_of(path).size(), 3u);
}

TEST_F(ALeasedFile, IsRefusedWhileSomebodyWrites) {
  const fs::path path = folder.write("a", content());
  const int writer = ::open(path.c_str(), O_WRONLY);
  const Status refused = LeasedFile::open(path, folder.path()).status();
  ::close(writer);
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("no lease"));
  EXPECT_TRUE(LeasedFile::open(path, folder.path()).is_ok());
}

TEST_F(ALeasedFile, NeedsAFileWithBytes) {
  const auto open = [&](const fs::path& path) {
    return LeasedFile::open(path, folder.path()).status().code();
  };
  EXPECT_EQ(open(folder / "nothing"), StatusCode::kNotFound);
  EXPECT_EQ(open(folder.write("empty", "")), StatusCode::kFailedPrecondition);
  EXPECT_FALSE(LeasedFile::open(folder.path(), folder.path()).is_ok());
}

TEST_F(ALeasedFile, HoldsAFileThatIsReadAndThatSomebodyCuts) {
  const fs::path path = folder.write("a", content());
  const HeldFile file = HeldFile::open(path).value();
  EXPECT_TRUE(file.is_leased());
  fs::resize_file(path, 10);
  EXPECT_EQ(text_of(file), content());
}

TEST(HeldFile, WithoutALeaseIsMappedAsItIs) {
  const TemporaryFolder folder;
  EXPECT_TRUE(HeldFile::open(folder.write("empty", "")).value().bytes().empty());
  const fs::path path = folder.write("a", content());
  const int writer = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const HeldFile file = HeldFile::open(path).value();
  EXPECT_FALSE(file.is_leased());
  EXPECT_EQ(file.bytes().size(), content().size());
  ::close(writer);
  EXPECT_EQ(HeldFile::open(folder / "nothing").status().code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/fuzz/readers.h"

namespace burnish {
namespace {

std::vector<uint8_t> content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Replays the fuzzers' findings and seeds. A reader must accept files named valid_*, and survive
/// the others.
class ReaderCorpus : public testing::TestWithParam<FuzzedReader> {};

TEST_P(ReaderCorpus, EveryFileIsTakenOrRefused) {
  const std::filesystem::path corpus = std::filesystem::path(BURNISH_FUZZ_CORPUS) / GetParam().name;
  size_t valid = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    const bool taken = GetParam().read(content_of(entry.path()));
    if (!entry.path().filename().string().starts_with("valid_")) continue;
    ++valid;
    EXPECT_TRUE(taken) << entry.path();
  }
  EXPECT_GT(valid, 0u);
}

/// Tries a fuzzer's first steps: one changed byte, and a cut end.
TEST_P(ReaderCorpus, ChangedAndCutFilesAreSurvived) {
  const std::filesystem::path corpus = std::filesystem::path(BURNISH_FUZZ_CORPUS) / GetParam().name;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    const std::vector<uint8_t> content = content_of(entry.path());
    const size_t step = 1 + content.size() / 200;
    for (size_t at = 0; at < content.size(); at += step) {
      std::vector<uint8_t> changed = content;
      changed[at] ^= static_cast<uint8_t>(1u << (at % 8));
      (void)GetParam().read(changed);
      (void)GetParam().read({content.data(), at});
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, ReaderCorpus,
                         testing::ValuesIn(fuzzed_readers().begin(), fuzzed_readers().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace burnish

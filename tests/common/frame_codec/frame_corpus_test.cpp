#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/common/frame_codec/frame_stream.h"

namespace burnish {
namespace {

std::vector<uint8_t> content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Replays the fuzzer's findings and seeds. A stream named valid_* must decode at least one frame.
TEST(FrameCorpus, EveryStreamIsSurvived) {
  int valid = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BURNISH_FRAME_CORPUS)) {
    const int decoded = decode_frame_stream(content_of(entry.path()));
    if (!entry.path().filename().string().starts_with("valid_")) continue;
    ++valid;
    EXPECT_GT(decoded, 0) << entry.path();
  }
  EXPECT_GT(valid, 0);
}

}  // namespace
}  // namespace burnish

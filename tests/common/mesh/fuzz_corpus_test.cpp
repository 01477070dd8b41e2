#include <filesystem>

#include "tests/common/mesh/reading.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

/// Replays the fuzzers' findings and seeds. A file named valid_* must be read; any other file must
/// give a valid mesh or a refusal.
class FuzzCorpus : public testing::TestWithParam<std::pair<const char*, MeshFormat>> {};

TEST_P(FuzzCorpus, EveryFileIsReadOrRefusedByName) {
  const auto [folder, format] = GetParam();
  const std::filesystem::path corpus = std::filesystem::path(BURNISH_FUZZ_CORPUS) / folder;
  size_t valid = 0;
  for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
    const auto mesh = parse(format, content_of(entry.path()));
    const bool must_be_valid = entry.path().filename().string().starts_with("valid_");
    valid += must_be_valid;
    EXPECT_TRUE(mesh.is_ok() || !must_be_valid) << entry.path() << mesh.status().message();
    if (!mesh.is_ok()) {
      EXPECT_THAT(mesh.status().message(), testing::StartsWith("scan: ")) << entry.path();
    }
  }
  EXPECT_GT(valid, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, FuzzCorpus,
    testing::Values(std::pair("ply", MeshFormat::kPly), std::pair("obj", MeshFormat::kObj),
                    std::pair("stl", MeshFormat::kStl), std::pair("off", MeshFormat::kOff),
                    std::pair("glb", MeshFormat::kGlb), std::pair("zip", MeshFormat::kZip)),
    [](const auto& test) { return std::string(test.param.first); });

}  // namespace
}  // namespace burnish

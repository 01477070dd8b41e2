#include <filesystem>

#include "tests/common/mesh/rewrite/rewriting.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<const char*, MeshFormat> kCorpora[] = {
    {"ply", MeshFormat::kPly}, {"obj", MeshFormat::kObj}, {"stl", MeshFormat::kStl},
    {"off", MeshFormat::kOff}, {"glb", MeshFormat::kGlb}, {"zip", MeshFormat::kZip}};

class RewriteCorpus : public testing::TestWithParam<std::pair<const char*, MeshFormat>> {};

/// Fuzzers and their first steps, one changed byte or a cut end: what can be read comes out the
/// same.
TEST_P(RewriteCorpus, EveryFileThatIsReadIsWrittenTheSame) {
  const auto [folder, format] = GetParam();
  size_t read = 0;
  const auto expect_same = [&](const std::string& content) {
    if (!parse(format, content).is_ok()) return;
    ++read;
    EXPECT_EQ(rewritten(format, content), content);
  };
  for (const auto& entry : fs::directory_iterator(fs::path(BURNISH_FUZZ_CORPUS) / folder)) {
    const std::string content = content_of(entry.path());
    expect_same(content);
    for (size_t at = 0; at < content.size(); ++at) {
      std::string changed = content;
      changed[at] = static_cast<char>(changed[at] ^ 1 << at % 8);
      expect_same(changed);
      expect_same(content.substr(0, at));
    }
  }
  EXPECT_GT(read, 10u);
}

/// A move must come back when the written file is read.
TEST_P(RewriteCorpus, AMovedFileReadsBackMoved) {
  const auto [folder, format] = GetParam();
  const auto move = [](size_t, const Vec3d& p) -> Vec3d { return 2 * p + Vec3d(4, 8, 16); };
  for (const auto& entry : fs::directory_iterator(fs::path(BURNISH_FUZZ_CORPUS) / folder)) {
    const std::string content = content_of(entry.path());
    if (!parse(format, content).is_ok()) continue;
    const TriangleMesh before = parsed(format, content);
    const TriangleMesh after = parsed(format, rewritten(format, content, move));
    ASSERT_EQ(after.vertices.size(), before.vertices.size()) << entry.path();
    EXPECT_EQ(after.triangles, before.triangles) << entry.path();
    EXPECT_EQ(after.colours, before.colours) << entry.path();
    for (size_t v = 0; v < before.vertices.size(); ++v)
      EXPECT_LT((after.vertices[v] - move(v, before.vertices[v])).norm(),
                1e-6 * (1 + after.vertices[v].norm()))
          << entry.path();
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, RewriteCorpus, testing::ValuesIn(kCorpora),
                         [](const auto& test) { return std::string(test.param.first); });

}  // namespace
}  // namespace burnish

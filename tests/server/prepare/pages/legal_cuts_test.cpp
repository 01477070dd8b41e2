#include <gtest/gtest.h>

#include "tests/common/pages/legal_cut.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/pages/crack_finder.h"
#include "tests/server/prepare/pages/pages_test_meshes.h"
#include "tests/server/prepare/pages/random_cut.h"

namespace burnish {
namespace {

constexpr uint32_t kCuts = 50;

ReadPages pages_of(const TriangleMesh& mesh, const PageTexels& texels = {}) {
  const TemporaryFolder folder;
  const Status status = build_pages_of(mesh, folder / "scan.pages", {}, {}, nullptr, texels);
  EXPECT_TRUE(status.is_ok()) << status.to_string();
  return read_pages(folder / "scan.pages").value();
}

size_t cracks_of_random_cuts(const ReadPages& read) {
  size_t cracks = 0;
  const CrackFinder finder(read, 1);
  EXPECT_EQ(finder.count_misfits(), 0u);
  for (int level = 1; level < read.level_count(); ++level)
    EXPECT_LE(finder.level_boundary(level).edges().size(),
              finder.level_boundary(level - 1).edges().size());
  for (uint32_t seed = 0; seed < kCuts; ++seed) {
    const PageSet cut = random_legal_cut(read.directory, seed);
    EXPECT_TRUE(is_legal_cut(read.directory, cut));
    cracks += finder.count_cracks(cut);
  }
  return cracks;
}

class LegalCuts : public testing::TestWithParam<const char*> {};

TEST_P(LegalCuts, HaveNoCracks) {
  EXPECT_EQ(cracks_of_random_cuts(pages_of(scan_of_kind(GetParam(), 30'000))), 0u);
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, LegalCuts,
                         testing::Values("tablet", "icosphere", "cylinder", "sheet", "blob",
                                         "sheets", "fan", "soup", "part"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(LegalCuts, OfDuplicatesAndSmallComponentsHaveNoCracks) {
  EXPECT_EQ(cracks_of_random_cuts(pages_of(with_duplicates(scan_of_kind("blob", 20'000)))), 0u);
  EXPECT_EQ(cracks_of_random_cuts(pages_of(small_components(5'000))), 0u);
  EXPECT_EQ(cracks_of_random_cuts(pages_of(loose_triangles(10'000))), 0u);
}

TEST(LegalCuts, OfPagesThatEndForTheirTexelsHaveNoCracks) {
  const TriangleMesh mesh = scan_of_kind("blob", 20'000);
  const std::vector<float> texels(mesh.triangles.size(), 10);
  for (const double of_page_max : {500.0, 15'000.0})  // joined first; simplified at once
    EXPECT_EQ(cracks_of_random_cuts(pages_of(mesh, {texels, of_page_max})), 0u) << of_page_max;
}

TEST(LegalCuts, OfAClosedScanAreClosed) {
  const ReadPages read = pages_of(scan_of_kind("icosphere", 30'000));
  const CrackFinder finder(read, 1);
  for (int level = 0; level < read.level_count(); ++level)
    EXPECT_TRUE(finder.level_boundary(level).edges().empty());
}

TEST(CrackFinder, FindsOneMovedVertex) {
  ReadPages read = pages_of(scan_of_kind("icosphere", 30'000));
  EXPECT_EQ(CrackFinder(read, 1).count_misfits(), 0u);
  ++read.pages[read.directory.head.level_begin(1)].positions[0].x();
  EXPECT_GE(CrackFinder(read, 1).count_misfits(), 2u);
}

TEST(CrackFinder, FindsThatACutIsNotLegal) {
  const ReadPages read = pages_of(scan_of_kind("icosphere", 30'000));
  PageSet cut = random_legal_cut(read.directory, 0);
  cut.assign(cut.size(), 1);
  cut[read.directory.head.level_begin(1)] = 0;
  EXPECT_GT(CrackFinder(read, 1).count_cracks(cut), 0u);
}

}  // namespace
}  // namespace burnish

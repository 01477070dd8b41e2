#include "server/prepare/pages/pages_need.h"

#include <malloc.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/process_memory.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/pages/pages_test_meshes.h"
#include "tests/server/prepare/pages/read_pages.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class PagesPeak : public testing::TestWithParam<const char*> {};

TEST_P(PagesPeak, IsPredictedAndThePredictionIsNotFarAbove) {
  const TriangleMesh mesh = scan_of_kind(GetParam(), 400'000);
  const MeshStatistics statistics = compute_statistics(mesh);
  const PagesInput scan = {mesh.vertices, mesh.triangles, mesh.colours, statistics};
  const TemporaryFolder folder;
  // Threads and their stacks are there.
  ASSERT_TRUE(build_pages_of(scan_of_kind("blob", 20'000), folder / "first.pages").is_ok());
  malloc_trim(0);
  const uint64_t before = resident_bytes();
  if (!reset_peak_resident_bytes()) GTEST_SKIP() << "the kernel does not reset the peak";
  ASSERT_TRUE(build_pages(scan, folder / "scan.pages").is_ok());
  const uint64_t of_scan = scan.vertices.size_bytes() + scan.triangles.size_bytes();
  const uint64_t taken = peak_resident_bytes() - before + of_scan;
  const PreparationNeed need = predict_pages(scan);
  RecordProperty("taken", std::to_string(taken));
  RecordProperty("predicted", std::to_string(need.memory_bytes));
  EXPECT_LE(taken, need.memory_bytes);
  // This soup's vertices join. The prediction is for one whose vertices do not agree.
  EXPECT_LE(need.memory_bytes, 1.75 * taken + (16 << 20));
  EXPECT_LE(std::filesystem::file_size(folder / "scan.pages"), need.file_bytes);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PagesPeak, testing::Values("blob", "tablet", "soup"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(PagesNeed, NamesTrianglesMemoryAndFile) {
  PreparationNeed need;
  need.counts.triangles = 7;
  need.memory_bytes = 5 << 20;
  need.file_bytes = 1;
  EXPECT_THAT(pages_need_text(need), HasSubstr("7 triangles takes 5 MiB"));
  EXPECT_THAT(pages_need_text(need), HasSubstr("a file of 1 MiB"));
}

}  // namespace
}  // namespace burnish

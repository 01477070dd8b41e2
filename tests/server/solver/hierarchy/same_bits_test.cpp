#include <string>

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/generate/generate.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/hierarchy_bytes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

void expect_same_bits(const TriangleMesh& mesh, int depth, Sheets sheets) {
  const TestSystem system(mesh, depth);
  use_threads(1);
  const std::string alone = HierarchyBytes::of(*make_hierarchy(*system.prepared, sheets));
  for (const int threads : {2, 7}) {
    use_threads(threads);
    EXPECT_TRUE(HierarchyBytes::of(*make_hierarchy(*system.prepared, sheets)) == alone)
        << threads << " threads";
  }
}

TEST(HierarchyBits, OfASmoothScanAreTheSameForAnyNumberOfThreads) {
  expect_same_bits(generate_scan({"blob", 40'000}).value(), 7, Sheets::kApart);
}

TEST(HierarchyBits, OfSheetsKeptTogetherAreTheSameForAnyNumberOfThreads) {
  expect_same_bits(reference::two_near_sheets(120, 0.004), 7, Sheets::kTogether);
}

TEST(HierarchyBits, OfSheetsKeptApartAreTheSameForAnyNumberOfThreads) {
  expect_same_bits(reference::two_near_sheets(120, 0.004), 7, Sheets::kApart);
}

TEST(HierarchyBits, OfSmallComponentsAreTheSameForAnyNumberOfThreads) {
  expect_same_bits(reference::small_components_over_a_sphere(), 5, Sheets::kApart);
}

}  // namespace
}  // namespace burnish

#include "server/prepare/preparation_need.h"

#include <malloc.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/process_memory.h"
#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/prepare/prepared_file.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Admits everything up to a limit, and records the last request.
class TestBudget : public PreparationBudget {
 public:
  explicit TestBudget(uint64_t bytes_max = UINT64_MAX / 2) : bytes_max_(bytes_max) {}
  uint64_t memory_bytes_max() const override { return bytes_max_; }
  Status ask(const PreparationNeed& need) override {
    last = need;
    if (need.memory_bytes <= bytes_max_) return Status::ok();
    return resource_exhausted("the limit is " + std::to_string(bytes_max_));
  }
  PreparationNeed last;

 private:
  const uint64_t bytes_max_;
};

TriangleMesh two_triangles() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0.1}, {0, 1, 0.3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TriangleMesh scan_of_kind(const std::string& kind, uint64_t vertices) {
  const auto scan = generate_scan({kind, vertices, 1});
  return scan.value();
}

struct Case {
  std::string kind;
  uint64_t vertices;
  int depth;
};

class PreparationPeak : public testing::TestWithParam<Case> {};

TEST_P(PreparationPeak, IsPredictedAndThePredictionIsNotFarAbove) {
  const Case& test = GetParam();
  const TriangleMesh mesh =
      test.vertices == 4 ? two_triangles() : scan_of_kind(test.kind, test.vertices);
  const uint64_t of_mesh = mesh.vertices.size() * sizeof(Vec3d) +
                           mesh.triangles.size() * sizeof(Triangle) + mesh.colours.size() * 4;
  ASSERT_TRUE(prepare(mesh, {4, 0.02, 0}).is_ok());  // starts the threads and their stacks
  malloc_trim(0);
  const uint64_t before = resident_bytes();
  TestBudget budget;
  PrepareReport report;
  const auto prepared = prepare(mesh, {test.depth, 0.02, 0, &budget}, {}, &report);
  ASSERT_TRUE(prepared.is_ok()) << prepared.status().message();
  uint64_t peak = 0;
  for (const PrepareReport::Phase& phase : report.phases) peak = std::max(peak, phase.peak_bytes);
  const uint64_t taken = peak - before + of_mesh;
  RecordProperty("taken", std::to_string(taken));
  RecordProperty("predicted", std::to_string(budget.last.memory_bytes));
  EXPECT_LE(taken, budget.last.memory_bytes);
  EXPECT_LE(budget.last.memory_bytes, 1.5 * taken + (4 << 20));
  EXPECT_GE(budget.last.file_bytes, make_prepared_header(**prepared).file_bytes);
  EXPECT_LE(budget.last.file_bytes, make_prepared_header(**prepared).file_bytes * 1.02 + 4096);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PreparationPeak,
                         testing::Values(Case{"two", 4, 8}, Case{"two", 4, 9},
                                         Case{"sheet", 20000, 8}, Case{"blob", 50000, 7},
                                         Case{"blob", 50000, 8}, Case{"tablet", 50000, 7},
                                         Case{"tablet", 50000, 9}, Case{"soup", 30000, 7},
                                         Case{"soup", 30000, 8}, Case{"fan", 20000, 8},
                                         Case{"sheets", 20000, 8}, Case{"part", 20000, 8},
                                         Case{"blob", 100000, 5}),
                         [](const auto& test) {
                           return test.param.kind + std::to_string(test.param.vertices) +
                                  "AtDepth" + std::to_string(test.param.depth);
                         });

TEST(Preparation, ThatDoesNotFitNamesDepthBytesLimitAndTheDeepestDepthThatDoes) {
  TestBudget budget(80 << 20);
  const TriangleMesh mesh = two_triangles();
  const Status status = prepare(mesh, {12, 0, 0, &budget}).status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("preparing 2 triangles at depth 12 takes more than"));
  EXPECT_THAT(status.message(), HasSubstr("depth 8 fits"));
  EXPECT_TRUE(prepare(mesh, {8, 0, 0, &budget}).is_ok());
  EXPECT_FALSE(prepare(mesh, {9, 0, 0, &budget}).is_ok());
}

TEST(Preparation, OfAScanForWhichNoDepthFitsSaysSo) {
  TestBudget budget(3 << 20);
  const Status status = prepare(make_icosphere(6, 1), {9, 0, 0, &budget}).status();
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace burnish

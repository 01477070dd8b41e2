#include "server/live/page_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using enum PageFrameKind;

/// A sphere of several pages at depth 5.
class PageSourceTest : public testing::Test {
 protected:
  PageSourceTest() {
    id_ = library_.import(sphere_file(1, 5), "ball").value().scan.id;
    mesh_ = store().open_mesh(id_, {5, 0}, {}).value();
    scan_ = store().open_pages(id_, {}).value();
    before_ = store().memory().taken();
  }
  MeshStore& store() { return *library_.store; }
  ScanPageSource::Pages pages(const std::vector<PageId>& numbers, PageFrameKind kind = kVertices) {
    return source().find_or_make(numbers, kind).value();
  }
  ScanPageSource& source() {
    if (!source_) source_ = sources_.find_or_make(scan_, mesh_);
    return *source_;
  }

  TestLibrary library_;
  std::string id_;
  std::shared_ptr<const SharedMesh> mesh_;
  std::shared_ptr<const ScanPages> scan_;
  uint64_t before_ = 0;
  PageSources sources_{store()};
  std::shared_ptr<ScanPageSource> source_;
};

TEST_F(PageSourceTest, APageIsThereOnceForAllAndGoesWithTheLast) {
  auto first = pages({2, 0}), second = pages({0});
  EXPECT_EQ(first[0]->number(), 2u);
  EXPECT_EQ(first[1], second[0]);
  EXPECT_NE(pages({0}, kCorners)[0], first[1]);
  first.clear();
  const uint64_t one = store().memory().taken();
  EXPECT_EQ(one, before_ + second[0]->memory.amount());
  second.clear();
  EXPECT_EQ(store().memory().taken(), before_);
}

TEST_F(PageSourceTest, AMeshHasOneSource) {
  EXPECT_EQ(sources_.find_or_make(scan_, mesh_), sources_.find_or_make(scan_, mesh_));
}

TEST_F(PageSourceTest, ThePredictionIsNoLessThanAPageTakesAndNotTwiceThat) {
  for (const PageFrameKind kind : {kVertices, kCorners})
    for (PageId page = 0; page < source().page_count(); ++page) {
      const auto made = pages({page}, kind)[0];
      const uint64_t predicted = predict_page_bytes(made->size, kind);
      EXPECT_GE(predicted, made->byte_count()) << page;
      EXPECT_LE(predicted, 2 * made->byte_count()) << page;
      EXPECT_EQ(made->memory.amount(), predicted);
    }
}

TEST_F(PageSourceTest, APageThatDoesNotFitIsRefused) {
  Quota& memory = store().memory();
  const Quota::Share rest = memory.take(kServer, memory.max() - memory.taken() - 100).value();
  const Status refused = source().find_or_make(std::vector<PageId>{0}, kVertices).status();
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(refused.message(), testing::HasSubstr("limits.memory_bytes_max"));
}

TEST_F(PageSourceTest, APagesSizeIsThatOfItsFrames) {
  const auto vertices = pages({0})[0], corners = pages({0}, kCorners)[0];
  EXPECT_EQ(vertices->size.vertices, vertices->evaluation.shown.value_count());
  EXPECT_EQ(vertices->size.corners, corners->evaluation.shown.value_count());
  EXPECT_EQ(vertices->cells, corners->cells);
}

}  // namespace
}  // namespace burnish

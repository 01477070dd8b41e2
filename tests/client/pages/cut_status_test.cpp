#include "client/pages/cut_status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/pages/ready_pages.h"

namespace burnish {
namespace {

using testing::HasSubstr;

CutStatus status_of(CutReason reason) {
  CutStatus status;
  status.reason = reason;
  status.is_full_detail = reason == CutReason::kNone;
  status.triangles_drawn = 270'000;
  status.triangles_in_view = 2'250'000;
  status.bytes_left = 1'340'000;
  status.failed_items = 3;
  return status;
}

TEST(CutStatus, FullDetailIsSaidInTwoWords) {
  EXPECT_EQ(status_text(status_of(CutReason::kNone)), "full detail");
}

TEST(CutStatus, TheDrawnPartTheWholeAndTheReasonAreSaid) {
  const std::string text = status_text(status_of(CutReason::kLoading));
  EXPECT_THAT(text, HasSubstr("12 %"));
  EXPECT_THAT(text, HasSubstr("2.25 M"));
  EXPECT_THAT(text, HasSubstr("1.3 MB"));
  EXPECT_THAT(status_text(status_of(CutReason::kFailed)), HasSubstr("3 pieces"));
}

TEST(CutStatus, APictureWithoutFullDetailIsSimplified) {
  EXPECT_EQ(simplified_text(status_of(CutReason::kNone)), "");
  EXPECT_EQ(simplified_text(status_of(CutReason::kMoving)), "simplified, 12 %");
  CutStatus status = status_of(CutReason::kLoading);
  status.triangles_drawn = 22'500;
  EXPECT_EQ(simplified_text(status), "simplified, 1 %");
  status.triangles_drawn = 2'250'000;
  EXPECT_EQ(simplified_text(status), "simplified, 99 %") << "coarse ones lie at its border";
}

TEST(CutStatus, TheDrawnPartIsAtMostOne) {
  CutStatus status;
  EXPECT_EQ(status.drawn_part(), 1) << "nothing is in view";
  status = {.triangles_drawn = 30, .triangles_in_view = 20};
  EXPECT_EQ(status.drawn_part(), 1);
}

uint64_t triangles_over(const KnownPages& known, double x, double distance) {
  return scan_triangles_in_view(
      known, make_page_view(camera_over(x, 0.5, distance), kFlightPicture, known.head().grid), 0);
}

TEST(CutStatus, TheScansTrianglesInViewAreCountedByPages) {
  const SyntheticScan scan = make_synthetic_scan();
  const KnownPages known = know_all(scan);
  EXPECT_EQ(triangles_over(known, 0.5, 4), scan.directory.head.scan_triangles);
  EXPECT_EQ(triangles_over(known, 20, 4), 0u);
  const PageView view =
      make_page_view(camera_over(0.5, 0.5, 0.3), kFlightPicture, known.head().grid);
  uint64_t expected = 0;
  for (PageId page = 0; page < known.head().level_pages[0]; ++page)
    if (is_visible(view, known.find(page)->bounds, 0)) expected += known.find(page)->triangles;
  EXPECT_EQ(triangles_over(known, 0.5, 0.3), expected);
}

TEST(CutStatus, UnknownPagesCountWithTheScansMean) {
  const SyntheticScan scan = make_synthetic_scan();
  const double all = static_cast<double>(scan.directory.head.scan_triangles);
  EXPECT_NEAR(triangles_over(KnownPages(scan.directory.head), 0.5, 4), all, 0.01 * all);
}

}  // namespace
}  // namespace burnish

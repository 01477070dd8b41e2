#include "client/app/widgets/words.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

CutStatus status_of(CutReason reason, uint64_t drawn) {
  CutStatus status;
  status.reason = reason;
  status.is_full_detail = reason == CutReason::kNone;
  status.triangles_drawn = drawn;
  status.triangles_in_view = 1000;
  return status;
}

TEST(Words, APictureWhosePagesAreOnTheirWayIsSimplified) {
  EXPECT_EQ(text_by_picture(status_of(CutReason::kLoading, 400)), "simplified, 40 %");
  EXPECT_EQ(text_by_picture(status_of(CutReason::kLoading, 53)), "simplified, 5.3 %");
  EXPECT_EQ(text_by_picture(status_of(CutReason::kFailed, 2000)), "simplified, 99 %");
}

TEST(Words, NothingIsSaidOfFullDetailAndOfMovingPictures) {
  EXPECT_EQ(text_by_picture(status_of(CutReason::kNone, 400)), "");
  EXPECT_EQ(text_by_picture(status_of(CutReason::kMoving, 400)), "");
}

}  // namespace
}  // namespace burnish

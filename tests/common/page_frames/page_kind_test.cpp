#include "common/page_frames/page_kind.h"

#include <gtest/gtest.h>

#include "common/page_frames/page_frame_body.h"

namespace burnish {
namespace {

TEST(PageKind, NoKeyOfAPageIsLargerThanItsEstimate) {
  for (const uint32_t size : {1u, 15u, 16u, 17u, 33u, 2048u}) {
    PageFrameBodyWriter body(1);
    body.add_gain(0, 1);
    body.add_values(0, std::vector<uint32_t>(size_t{3} * size, ~0u));
    EXPECT_EQ(body.byte_count(), page_key_bytes_max(size));
  }
}

TEST(PageKind, CornersAreCheaperOnlyWhereTheyAreClearlyFewer) {
  EXPECT_EQ(cheaper_kind(1000, 1000), PageFrameKind::kVertices);
  EXPECT_EQ(cheaper_kind(1000, 500), PageFrameKind::kCorners);
  EXPECT_EQ(cheaper_kind(0, 0), PageFrameKind::kVertices);
}

}  // namespace
}  // namespace burnish

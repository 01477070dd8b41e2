#include "client/scene/null_page_renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr ImageSize kNullSize{32, 24};

class NullPages : public testing::Test {
 protected:
  void SetUp() override {
    renderer_.open(make_page_space(split_.grid, 5));
    ASSERT_TRUE(renderer_.reserve(1).is_ok());
    ASSERT_TRUE(renderer_.upload_page(0, mesh_).is_ok());
    camera_.distance = 6;
    camera_.scene_radius = 3;
  }

  const SplitMesh split_ = split_into_pages(make_icosphere(2, 1), 1000);
  const PageMesh mesh_ = make_page_mesh(split_.pages.at(0), split_.grid);
  const PatchRange all_{0, 0, static_cast<uint32_t>(mesh_.triangles.size())};
  Camera camera_;
  NullPageRenderer renderer_;
};

TEST_F(NullPages, RemembersWhatItWasAskedToDraw) {
  ASSERT_TRUE(renderer_.draw(camera_, kNullSize, {.flat = true}, {&all_, 1}).is_ok());
  EXPECT_TRUE(renderer_.style().flat);
  EXPECT_EQ(renderer_.camera(), camera_);
  EXPECT_EQ(renderer_.patches().size(), 1u);
  EXPECT_EQ(renderer_.read_pixels().value().size, kNullSize);
}

TEST_F(NullPages, RefusesMoreSlotsThanTheLimit) {
  const Status status = renderer_.reserve(kPageSlotsMax + 1);
  EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(status.message(), HasSubstr("262145"));
  EXPECT_THAT(status.message(), HasSubstr("262144"));
}

TEST_F(NullPages, RefusesToReadBeforeTheFirstPictureAndAbsurdSizes) {
  EXPECT_EQ(renderer_.read_pixels().status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(renderer_.draw({}, {8, 8}, {}, {}).code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace burnish

#include "client/gl/fence.h"

#include <gtest/gtest.h>

#include "client/gl/context_egl.h"

namespace burnish {
namespace {

class Fences : public testing::TestWithParam<GlKind> {
 protected:
  const std::unique_ptr<EglContext> context_ = EglContext::create(GetParam()).value();
};

TEST_P(Fences, OneThatStandsNowhereIsReached) {
  Fence fence;
  EXPECT_TRUE(fence.is_reached());
}

TEST_P(Fences, IsReachedOnceTheCardHasDoneAllBeforeIt) {
  Fence fence;
  for (int picture = 0; picture < 3; ++picture) {
    fence.put();
    glFinish();
    EXPECT_TRUE(fence.is_reached());
    EXPECT_TRUE(fence.is_reached()) << "a second question";
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

INSTANTIATE_TEST_SUITE_P(Kinds, Fences, testing::Values(GlKind::kDesktop, GlKind::kEmbedded));

}  // namespace
}  // namespace burnish

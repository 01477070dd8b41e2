#include "client/pictures/lone_renderer.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "client/gl/capabilities.h"
#include "client/gl/context_egl.h"

namespace burnish {
namespace {

bool is_there_a_card() {
  const auto context = EglContext::create();
  return context.is_ok() && !card_capabilities().is_software;
}

TEST(LoneRenderer, TakesOpenGLWithACardAlone) {
  const bool expected = is_there_a_card();
  EXPECT_EQ(LoneRenderer().has_card(), expected);
}

TEST(LoneRenderer, DrawsWithoutADriver) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a new process, which loads EGL anew
  ASSERT_EQ(setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1), 0);
  EXPECT_EXIT(
      {
        LoneRenderer renderer;
        const bool is_drawn = renderer->draw({}, {64, 48}, {}, {}).is_ok() &&
                              renderer->read_pixels()->pixel(10, 10)[0] > 100;
        std::exit(is_drawn && !renderer.has_card() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
  unsetenv("__EGL_VENDOR_LIBRARY_DIRS");
}

}  // namespace
}  // namespace burnish

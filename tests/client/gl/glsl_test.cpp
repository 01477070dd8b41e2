#include "client/gl/glsl.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Glsl, HasNeitherCommentsNorIndentationNorEmptyLines) {
  const char* const text = R"(
// A comment.
float half_of(float x) {  // of a number

  return x / 2.0;
}
#ifdef ALL
#endif
)"_glsl;
  EXPECT_STREQ(text, "float half_of(float x) {  \nreturn x / 2.0;\n}\n#ifdef ALL\n#endif\n");
}

}  // namespace
}  // namespace burnish

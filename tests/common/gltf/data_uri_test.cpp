#include "common/gltf/data_uri.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(DataUri, ItsSchemeAndItsMarkHaveNoCase) {
  for (const char* uri : {"data:;base64,Zm8=", "DATA:;BASE64,Zm8=", "Data:a/b;Base64,Zm8="}) {
    ASSERT_TRUE(is_data_uri(uri)) << uri;
    EXPECT_THAT(read_data_uri(uri, "buffer 0").value(), ElementsAre('f', 'o')) << uri;
  }
}

TEST(DataUri, AFileIsNone) {
  for (const char* uri : {"", "data", "data.bin", "dat%61:;base64,Zm8="})
    EXPECT_FALSE(is_data_uri(uri)) << uri;
}

TEST(DataUri, OfAnotherEncodingOrDamagedIsRefusedByItsPlace) {
  for (const char* uri : {"data:", "data:,fo", "data:;base64",
                          "data:a;b,;base64,Zm8=", "data:;base64,Zm8!", "DATA:;base64,Z"}) {
    const Status status = read_data_uri(uri, "buffer 7").status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument) << uri;
    EXPECT_THAT(status.message(), HasSubstr("buffer 7")) << uri;
  }
}

}  // namespace
}  // namespace burnish

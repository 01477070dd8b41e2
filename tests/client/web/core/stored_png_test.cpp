#include "client/web/core/stored_png.h"

#include <gtest/gtest.h>

#include "client/scene/png_reader.h"
#include "tests/client/scene/png_description.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

TEST(StoredPng, AnotherReaderFindsTheSamePixels) {
  Image image{{200, 150}, {}};  // more than one stored block
  for (int i = 0; i < 3 * 200 * 150; ++i) image.rgb.push_back(static_cast<uint8_t>(i * 7 / 3));
  const TemporaryFolder folder;
  const auto read = read_png(folder.write("a.png", stored_png(image)), 1000);
  ASSERT_TRUE(read.is_ok()) << read.status().message();
  EXPECT_EQ(read->size, image.size);
  EXPECT_EQ(read->rgb, image.rgb);
}

TEST(StoredPng, ANoteIsItsDescription) {
  Image image{{20, 16}, std::vector<uint8_t>(3 * 20 * 16, 90)};
  EXPECT_EQ(png_description(stored_png(image)), "");
  image.note = "simplified, 40 %";
  EXPECT_EQ(png_description(stored_png(image)), "simplified, 40 %");
}

}  // namespace
}  // namespace burnish

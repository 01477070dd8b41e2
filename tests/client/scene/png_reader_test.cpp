#include "client/scene/png_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/scene/png_writer.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

Image shaded(const ImageSize& size) {
  Image image{size, {}};
  for (int i = 0; i < 3 * size.width * size.height; ++i) image.rgb.push_back(uint8_t(7 * i));
  return image;
}

TEST(PngReader, ReadsWhatTheWriterWrote) {
  const TemporaryFolder folder;
  const Image image = shaded({40, 20});
  ASSERT_TRUE(write_png(image, folder / "a.png").is_ok());
  const auto read = read_png(folder / "a.png", 40);
  ASSERT_TRUE(read.is_ok()) << read.status().message();
  EXPECT_EQ(read->size, image.size);
  EXPECT_EQ(read->rgb, image.rgb);
}

TEST(PngReader, RefusesALargePictureByItsSize) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_png(shaded({40, 20}), folder / "a.png").is_ok());
  const auto read = read_png(folder / "a.png", 39);
  EXPECT_EQ(read.status().code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(read.status().message(), testing::HasSubstr("40x20"));
}

TEST(PngReader, ADamagedFileIsDataLoss) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_png(shaded({40, 20}), folder / "a.png").is_ok());
  std::filesystem::resize_file(folder / "a.png", 60);
  EXPECT_EQ(read_png(folder / "a.png", 40).status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(read_png(folder.write("b.png", "no picture"), 40).status().code(),
            StatusCode::kDataLoss);
}

}  // namespace
}  // namespace burnish

#include "client/scene/png_writer.h"

#include <png.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/text_lines.h"
#include "tests/client/scene/png_description.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class PngWriter : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("burnish_png_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

Image make_gradient(int width, int height) {
  Image image{{width, height}, {}};
  for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<uint8_t>(i * 7));
  return image;
}

TEST_F(PngWriter, PixelsComeBackAsTheyWere) {
  const Image image = make_gradient(37, 19);
  ASSERT_TRUE(write_png(image, folder_ / "a.png").is_ok());
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&header, (folder_ / "a.png").c_str()));
  header.format = PNG_FORMAT_RGB;
  EXPECT_EQ(header.width, 37u);
  EXPECT_EQ(header.height, 19u);
  std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(header));
  ASSERT_TRUE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr));
  EXPECT_EQ(pixels, image.rgb);
}

TEST_F(PngWriter, ANoteIsTheDescriptionInTheFile) {
  Image image = make_gradient(37, 19);
  const auto description = [&] {
    EXPECT_TRUE(write_png(image, folder_ / "a.png").is_ok());
    return png_description(read_text_file(folder_ / "a.png").value());
  };
  EXPECT_EQ(description(), "");
  image.note = "simplified, 40 %";
  EXPECT_EQ(description(), "simplified, 40 %");
}

TEST_F(PngWriter, SizesOutsideTheLimitsAreNamed) {
  EXPECT_THAT(write_png(make_gradient(15, 16), folder_ / "a.png").message(),
              HasSubstr("15x16 pixels: both sides must be within 16..8192"));
  EXPECT_THAT(write_png(Image{{16, 8193}, {}}, folder_ / "a.png").message(), HasSubstr("16x8193"));
  EXPECT_FALSE(fs::exists(folder_ / "a.png"));
}

TEST_F(PngWriter, AMissingFolderIsNotFoundAndNamed) {
  const Status status = write_png(make_gradient(16, 16), folder_ / "none/a.png");
  EXPECT_EQ(status.code(), StatusCode::kNotFound);
  EXPECT_THAT(status.message(), HasSubstr("none"));
}

TEST_F(PngWriter, LeavesNoFileBesideThePicture) {
  ASSERT_TRUE(write_png(make_gradient(16, 16), folder_ / "a.png").is_ok());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace burnish

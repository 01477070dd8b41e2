#include "client/model/workspace/session_pictures.h"

#include <gtest/gtest.h>

#include "client/scene/png_reader.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

RecentSession session_with(const std::string& id) {
  return {.session = "desk", .id = id};
}

/// Red at the left, blue at the right.
Image two_halves(const ImageSize& size) {
  Image image{size, {}};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (const int value : {x < size.width / 2 ? 200 : 0, 0, x < size.width / 2 ? 0 : 100})
        image.rgb.push_back(static_cast<uint8_t>(value));
  return image;
}

TEST(SessionPictures, ASmallPictureIsTheMiddleOfTheLargeOne) {
  const Image small = shrunk(two_halves({600, 300}), {40, 40});
  ASSERT_EQ(small.size, (ImageSize{40, 40}));
  EXPECT_EQ(small.pixel(5, 20)[0], 200);
  EXPECT_EQ(small.pixel(35, 20)[2], 100);
}

TEST(SessionPictures, AreKeptForTheRecentSessionsAlone) {
  const TemporaryFolder folder;
  const auto pictures = folder / "pictures";
  const Image image = two_halves({512, 320});
  const RecentSession a = session_with("0a"), b = session_with("0b");
  ASSERT_TRUE(keep_picture(pictures, a, image, {a}).is_ok());
  EXPECT_TRUE(std::filesystem::exists(picture_path(pictures, a)));
  ASSERT_TRUE(keep_picture(pictures, b, image, {b}).is_ok());
  EXPECT_FALSE(std::filesystem::exists(picture_path(pictures, a)));
  EXPECT_EQ(read_png(picture_path(pictures, b), 256)->size, kSessionPictureSize);
  EXPECT_EQ(std::filesystem::status(pictures).permissions(), std::filesystem::perms(0700));
}

TEST(SessionPictures, AnIdThatIsAPathHasNoPicture) {
  EXPECT_TRUE(picture_path("/tmp", session_with("../../etc/passwd")).empty());
  EXPECT_TRUE(picture_path("/tmp", session_with("")).empty());
}

}  // namespace
}  // namespace burnish

#include "common/picture/picture_kind.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "common/base/limits.h"

namespace burnish {

namespace {

using namespace std::string_view_literals;

/// The first bytes of a kind of picture.
struct Magic {
  std::string_view bytes;
  size_t at = 0;
};

constexpr Magic kPngMagic = {"\x89PNG\r\n\x1a\n"sv};
constexpr Magic kJpegMagic = {"\xff\xd8\xff"sv};
constexpr Magic kWebpMagic = {"WEBP"sv, 8};

struct OtherKind {
  const char* name;
  Magic magic;
};
constexpr OtherKind kOthers[] = {
    {"KTX2", {"\xabKTX 20\xbb"sv}}, {"DDS", {"DDS "sv}}, {"TIFF", {"II*\0"sv}},
    {"TIFF", {"MM\0*"sv}},          {"GIF", {"GIF8"sv}}, {"AVIF", {"ftypavif"sv, 4}},
    {"OpenEXR", {"v/1\x01"sv}},     {"BMP", {"BM"sv}}};

bool begins_with(std::string_view file, const Magic& magic) {
  return file.size() >= magic.at && file.substr(magic.at).starts_with(magic.bytes);
}

}  // namespace

Result<PictureKind> kind_of_picture(std::span<const uint8_t> bytes) {
  if (bytes.size() > kPictureBytesMax)
    return invalid_argument("picture of " + std::to_string(bytes.size()) + " bytes, the limit is " +
                            std::to_string(kPictureBytesMax));
  const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (begins_with(file, kPngMagic)) return PictureKind::kPng;
  if (begins_with(file, kJpegMagic)) return PictureKind::kJpeg;
  if (file.starts_with("RIFF") && begins_with(file, kWebpMagic)) return PictureKind::kWebp;
  const auto other = std::ranges::find_if(
      kOthers, [&](const OtherKind& kind) { return begins_with(file, kind.magic); });
  if (other == std::end(kOthers)) return unimplemented("the picture is neither PNG, JPEG nor WebP");
  return unimplemented(std::string("PNG, JPEG and WebP are read, ") + other->name + " is not");
}

}  // namespace burnish

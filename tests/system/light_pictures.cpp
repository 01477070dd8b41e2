// Draws the same scan in every light of `burnish render --light`, for docs/light.md.
// light_pictures OUT

#include <cstdio>
#include <filesystem>

#include "client/pictures/picture.h"
#include "client/scene/png_writer.h"
#include "common/base/check.h"
#include "common/generate/generate.h"
#include "tests/system/sheet.h"

namespace burnish {
namespace {

constexpr ImageSize kTile{640, 480};  // drawn at twice the size of the sheet
constexpr Box kScan{80, 40, 480, 400};

Image draw(const TriangleMesh& mesh, const Lighting& lighting) {
  PictureOptions picture{
      .size = kTile, .azimuth_degrees = 12, .elevation_degrees = 8, .zoom = 1.35};
  picture.style.lighting = lighting;
  auto image = draw_picture(mesh, picture);
  BURNISH_CHECK(image.is_ok(), "the picture is drawn");
  return halved(cut(*image, kScan));
}

void draw_all(const std::filesystem::path& out) {
  const auto tablet = generate_scan({.kind = "tablet", .vertices = 400'000});
  BURNISH_CHECK(tablet.is_ok(), "the tablet is generated");
  std::vector<Image> tiles;
  for (int kind = 0; kind < static_cast<int>(LightKind::kUnlit); ++kind)  // it has no colours
    tiles.push_back(draw(*tablet, {.kind = static_cast<LightKind>(kind)}));
  tiles.push_back(draw(*tablet, {.occlusion = 1}));
  BURNISH_CHECK(write_png(in_rows(tiles, 4), out / "lights.png").is_ok(), "the sheet is written");
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: light_pictures OUT\n");
    return 2;
  }
  burnish::draw_all(words[1]);
}

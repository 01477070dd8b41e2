// Megatexels per second of one core that get edited colours in a picture: texture_bench [SIDE
// [TEXELS_OF_TRIANGLE]]

#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>

#include "common/base/parallel.h"
#include "common/mesh/rewrite/pictures/edited_pictures.h"
#include "tests/common/picture/encoding.h"

namespace burnish {
namespace {

/// A square grid over the whole picture; its vertices get darker towards one side.
struct EditedGrid {
  explicit EditedGrid(uint32_t cells) {
    SurfaceMaterial material;
    material.picture = 0;
    surface.textures.materials = {material};
    const float step = 1 / static_cast<float>(cells);
    for (uint32_t y = 0; y <= cells; ++y)
      for (uint32_t x = 0; x <= cells; ++x) {
        surface.mesh.vertices.emplace_back(x, y, 0);
        surface.textures.coordinates.push_back(
            {static_cast<float>(x) * step, static_cast<float>(y) * step});
        before.push_back({128, 128, 128, 255});
        const auto darker = static_cast<uint8_t>(127 - 60 * x / cells);
        after.push_back({darker, darker, 128, 255});
      }
    const uint32_t side = cells + 1;
    for (uint32_t y = 0; y < cells; ++y)
      for (uint32_t x = 0; x < cells; ++x) {
        const uint32_t a = y * side + x;
        add({a, a + 1, a + side + 1});
        add({a, a + side + 1, a + side});
      }
  }

  void add(const Triangle& triangle) {
    surface.mesh.triangles.push_back(triangle);
    surface.textures.triangles.push_back({0, {triangle[0], triangle[1], triangle[2]}});
  }

  TexturedSurface surface;
  std::vector<Rgba8> before, after;
};

std::string stone(uint32_t side, bool is_jpeg) {
  const Picture picture = drawn(side, side, [](uint32_t x, uint32_t y) {
    const auto grain = static_cast<int>((x * 2654435761U ^ y * 2246822519U) >> 27);
    const auto level = static_cast<uint8_t>(110 + 40 * std::sin(0.02 * x) + grain);
    return Rgba8{level, level, static_cast<uint8_t>(level - 20), 255};
  });
  return is_jpeg ? jpeg_of(picture, {.quality = 92}) : png_of(picture);
}

void measure(const char* kind, EditedGrid& grid, uint32_t side, const std::string& file) {
  grid.surface.textures.pictures = {
      {kind, [&] { return Result(std::vector<uint8_t>(file.begin(), file.end())); }, kind}};
  PictureWork work;
  const std::clock_t start = std::clock();  // of this thread alone: other work does not count
  const auto edited = edit_pictures(grid.surface, {grid.before, grid.after}, work);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!edited.is_ok()) {
    std::printf("%s\n", edited.status().message().c_str());
    return;
  }
  std::printf(
      "%-5s %6.1f s %8.1f Mtexel/s; %llu texels changed, %+.2f %% of bytes\n", kind, seconds,
      1e-6 * side * side / seconds, static_cast<unsigned long long>(work.report.texels),
      100.0 * static_cast<double>((*edited)[0].bytes.size()) / static_cast<double>(file.size()) -
          100);
}

}  // namespace
}  // namespace burnish

int main(int count, char** words) {
  const auto side = static_cast<uint32_t>(count > 1 ? std::stoi(words[1]) : 8192);
  const double texels = count > 2 ? std::stod(words[2]) : 36;
  burnish::use_threads(1);
  burnish::EditedGrid grid(static_cast<uint32_t>(side / std::sqrt(2 * texels)));
  burnish::measure("JPEG", grid, side, burnish::stone(side, true));
  burnish::measure("PNG", grid, side, burnish::stone(side, false));
}

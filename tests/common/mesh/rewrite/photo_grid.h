#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/base/types.h"
#include "common/picture/picture.h"
#include "tests/common/picture/encoding.h"

namespace burnish {

/// A square of blocks x blocks charts, each cut out of a photo with an exposure of its own. The
/// colour of the surface is known everywhere. Charts that touch on the surface do not touch on the
/// picture.
struct PhotoGrid {
  int blocks = 3;                    // along a side
  int cells = 4;                     // of a block, along a side
  int texels = 44;                   // of a block on the picture, along a side
  bool has_doubled_corners = false;  // each block has vertices of its own
  double contrast = 1;               // 0: all exposures are alike
  static constexpr int kMargin = 6;  // texels around a chart, of the same photo

  int side() const { return blocks * cells; }

  /// Returns the light of the surface: soft colours with letters finer than a cell.
  static Vec3d albedo(double x, double y) {
    const double wave = std::sin(0.9 * x) * std::cos(0.7 * y), fine = std::sin(5 * x + 3 * y);
    return {0.3 + 0.1 * wave + 0.05 * fine, 0.25 + 0.08 * std::cos(x - y), 0.2 - 0.05 * fine};
  }

  /// Returns the exposure of a block by channel: photos also differ in white balance.
  Vec3d exposure(int block) const {
    const auto part = [&](int prime) { return (block * prime % 11) / 10.0 - 0.5; };
    return (contrast * Vec3d(part(7), 0.7 * part(7) + 0.1 * part(3), part(7) - 0.1 * part(5)))
        .array()
        .exp();
  }

  /// Returns where a place of a block lies on the picture, in texels.
  std::array<double, 2> on_picture(int block, double x, double y) const {
    const int tile = (block * 4 + 2) % (blocks * blocks);
    const double scale = double(texels - 2 * kMargin) / cells;
    return {tile % blocks * texels + kMargin + scale * (x - block % blocks * cells),
            tile / blocks * texels + kMargin + scale * (y - block / blocks * cells)};
  }

  Picture picture() const {
    const auto size = static_cast<uint32_t>(blocks * texels);
    Picture picture = drawn(size, size, [](uint32_t, uint32_t) { return Rgba8{0, 0, 0, 255}; });
    for (int block = 0; block < blocks * blocks; ++block) draw(block, picture);
    return picture;
  }

  std::string obj() const {
    std::string text = "mtllib skin.mtl\n", faces = "usemtl skin\n";
    const int across = cells + 1, of_block = across * across;
    if (!has_doubled_corners)
      for (int y = 0; y <= side(); ++y)
        for (int x = 0; x <= side(); ++x) text += vertex(x, y);
    for (int block = 0; block < blocks * blocks; ++block) {
      const int left = block % blocks * cells, top = block / blocks * cells;
      for (int y = 0; y < across; ++y)
        for (int x = 0; x < across; ++x) {
          if (has_doubled_corners) text += vertex(left + x, top + y);
          text += coordinate(block, left + x, top + y);
        }
      const auto corner = [&](int x, int y) {
        const int place = block * of_block + y * across + x + 1;
        const int shared = (top + y) * (side() + 1) + left + x + 1;
        return " " + std::to_string(has_doubled_corners ? place : shared) + "/" +
               std::to_string(place);
      };
      for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
          faces += "f" + corner(x, y) + corner(x + 1, y) + corner(x + 1, y + 1) + "\n";
          faces += "f" + corner(x, y) + corner(x + 1, y + 1) + corner(x, y + 1) + "\n";
        }
    }
    return text + faces;
  }

  /// Returns the median step between charts in a picture, in levels: measured at places along all
  /// borders, one texel inside of both sides.
  double median_step(const Picture& picture) const {
    return median_step([&](double x, double y) {
      const Rgba8 texel = texel_at(picture, {x, y});
      return Vec3d(texel[0], texel[1], texel[2]);
    });
  }

  /// Does so for what else shows the surface: `colour_at(x, y)` returns levels.
  template <typename ColourAt>
  double median_step(const ColourAt& colour_at) const {
    std::vector<double> steps;
    const auto difference = [&](double x, double y, double other_x, double other_y) {
      return (colour_at(x, y) - colour_at(other_x, other_y)).cwiseAbs().mean();
    };
    const double inset = 0.6 * cells / (texels - 2 * kMargin);
    for (int border = 1; border < blocks; ++border)
      for (double along = 0.3; along < side(); along += 0.37) {
        const double at = border * cells;
        steps.push_back(difference(at - inset, along, at + inset, along));
        steps.push_back(difference(along, at - inset, along, at + inset));
      }
    std::ranges::nth_element(steps, steps.begin() + static_cast<ptrdiff_t>(steps.size() / 2));
    return steps[steps.size() / 2];
  }

  /// Returns how far the texels of all charts are from the surface's colours, as the deviation of
  /// the logarithm of their ratio: the brightness of the whole does not count.
  double albedo_error(const Picture& picture) const {
    double sum = 0, squares = 0, count = 0;
    for (double y = 0.11; y < side(); y += 0.23)
      for (double x = 0.11; x < side(); x += 0.23) {
        const Rgba8 texel = texel_at(picture, {x, y});
        const Vec3d light = albedo(x, y);
        for (int i = 0; i < 3; ++i) {
          const double ratio = std::log(std::pow(texel[i] / 255.0, 2.2) / light[i]);
          sum += ratio;
          squares += ratio * ratio;
          ++count;
        }
      }
    return std::sqrt(squares / count - sum * sum / count / count);
  }

  /// Returns the texel that shows a place of the surface.
  Rgba8 texel_at(const Picture& picture, const std::array<double, 2>& place) const {
    const auto along = [&](double at) {
      return std::min(static_cast<int>(at) / cells, blocks - 1);
    };
    const auto [u, v] = on_picture(along(place[1]) * blocks + along(place[0]), place[0], place[1]);
    return picture.at(static_cast<uint32_t>(u), static_cast<uint32_t>(v));
  }

 private:
  void draw(int block, Picture& picture) const {
    const double scale = double(cells) / (texels - 2 * kMargin);
    const int left = block % blocks * cells, top = block / blocks * cells;
    const auto [u0, v0] = on_picture(block, left, top);
    for (int v = -kMargin; v < texels - kMargin; ++v)
      for (int u = -kMargin; u < texels - kMargin; ++u) {
        const Vec3d light =
            albedo(left + scale * (u + 0.5), top + scale * (v + 0.5)).cwiseProduct(exposure(block));
        Rgba8& texel = picture.pixels[size_t(v0 + v) * picture.width + size_t(u0 + u)];
        for (int i = 0; i < 3; ++i)
          texel[i] = static_cast<uint8_t>(
              std::lround(255 * std::pow(std::clamp(light[i], 0.0, 1.0), 1 / 2.2)));
      }
  }

  static std::string vertex(int x, int y) {
    return "v " + std::to_string(x) + " " + std::to_string(y) + " " +
           std::to_string((x * y) % 3 * 0.1) + "\n";
  }

  std::string coordinate(int block, int x, int y) const {
    const auto [u, v] = on_picture(block, x, y);
    const double size = blocks * texels;
    return "vt " + std::to_string(u / size) + " " + std::to_string(1 - v / size) + "\n";
  }
};

}  // namespace burnish

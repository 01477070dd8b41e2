#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/common/picture/encoding.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/sheets/painted_ball.h"
#include "tests/server/prepare/sheets/sheets_of_ball.h"

namespace burnish {
namespace {

/// A square of quads of side 1. A part of it, the face, has many texels and a fine pattern; the
/// drapery around it has few texels and a smooth one.
struct FaceAndDrapery {
  int quads = 40;  // of a side
  int face_begin = 14;
  int face_end = 26;
  int face_texels = 380;     // of a side
  int drapery_texels = 240;  // of a side
  double wave = 4;           // of the face's pattern, texels

  bool is_on_face(double x, double y) const {
    return std::min(x, y) >= face_begin && std::max(x, y) <= face_end;
  }

  Rgba8 face_at(double x, double y) const {
    const double turn = 2 * std::numbers::pi / wave * face_texels / (face_end - face_begin);
    return {wave_byte(turn * x), wave_byte(turn * y), 128, 255};
  }

  Rgba8 drapery_at(double x, double y) const {
    return {wave_byte(x / 2), 128, wave_byte(y / 2), 255};
  }

  std::vector<uint8_t> zip() const { return zip_of(obj(), png_of(picture())); }

 private:
  /// A chart of the picture.
  struct Place {
    double begin;   ///< quads
    double scale;   ///< texels a quad
    double column;  ///< of the begin
  };
  static constexpr int kMargin = 4;  // texels around each chart

  static uint8_t wave_byte(double phase) {
    return static_cast<uint8_t>(std::lround(128 + 100 * std::sin(phase)));
  }

  Place place(bool is_face) const {
    if (is_face)
      return {double(face_begin), double(face_texels) / (face_end - face_begin), kMargin};
    return {0, double(drapery_texels) / quads, face_texels + 3.0 * kMargin};
  }
  uint32_t width() const { return face_texels + drapery_texels + 4 * kMargin; }
  uint32_t height() const { return std::max(face_texels, drapery_texels) + 2 * kMargin; }

  Picture picture() const {
    return drawn(width(), height(), [&](uint32_t column, uint32_t row) {
      const bool is_face = static_cast<int>(column) < face_texels + 2 * kMargin;
      const Place at = place(is_face);
      const double x = (column + 0.5 - at.column) / at.scale + at.begin;
      const double y = (row + 0.5 - kMargin) / at.scale + at.begin;
      return is_face ? face_at(x, y) : drapery_at(x, y);
    });
  }

  std::string obj() const {
    std::string text = "mtllib ball.mtl\nusemtl skin\n";
    for (int y = 0; y < quads; ++y)
      for (int x = 0; x < quads; ++x) {
        const bool is_face = is_on_face(x + 0.5, y + 0.5);
        text += corner(x, y, is_face) + corner(x + 1, y, is_face);
        text += corner(x + 1, y + 1, is_face) + corner(x, y + 1, is_face);
        text += "f -4/-4 -3/-3 -2/-2\nf -4/-4 -2/-2 -1/-1\n";
      }
    return text;
  }

  /// Returns a vertex and its place on the picture.
  std::string corner(int x, int y, bool is_face) const {
    const Place at = place(is_face);
    const double u = (at.column + (x - at.begin) * at.scale) / width();
    const double v = 1 - (kMargin + (y - at.begin) * at.scale) / height();
    std::array<char, 120> lines;
    std::snprintf(lines.data(), lines.size(), "v %d %d %.6g\nvt %.9g %.9g\n", x, y,
                  0.3 * std::sin(0.3 * x + 0.2 * y), u, v);
    return lines.data();
  }
};

/// Returns how well the finest sheets show the face; dB.
double psnr_of_face(const FaceAndDrapery& scan) {
  const TemporaryFolder folder;
  const std::vector<uint8_t> zip = scan.zip();
  const PageFile pages = pages_of_archive(zip, folder / "scan.pages");
  SheetsReport report;
  EXPECT_TRUE(*build_sheets_of_archive(zip, pages, folder / "scan.sheets", {}, {}, &report));
  const auto face = [&](const Vec3d& at) -> std::optional<Rgba8> {
    if (!scan.is_on_face(at.x(), at.y())) return std::nullopt;
    return scan.face_at(at.x(), at.y());
  };
  const double psnr =
      psnr_of_level(ColourAt(face), pages, open_sheets(folder / "scan.sheets", pages), 0);
  std::cout << report.levels[0].pages << " pages, " << report.levels[0].texels << " texels for "
            << report.used_texels << ", " << psnr << " dB\n";
  return psnr;
}

TEST(DensePart, IsAsSharpBesideACoarseOneAsAlone) {
  for (const double wave : {3.0, 4.0, 8.0}) {
    const FaceAndDrapery both{.wave = wave};
    FaceAndDrapery alone = both;
    alone.quads = 12;
    alone.face_begin = 0;
    alone.face_end = 12;
    EXPECT_GE(psnr_of_face(both), psnr_of_face(alone) - 1) << wave;
  }
}

}  // namespace
}  // namespace burnish

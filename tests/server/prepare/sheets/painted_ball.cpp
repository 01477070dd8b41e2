#include "tests/server/prepare/sheets/painted_ball.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "common/archive/archive_writer.h"
#include "tests/common/picture/encoding.h"

namespace burnish {

namespace {

constexpr uint32_t kFacesPerRow = 3;

/// Returns a point of a cube's side, -1 to 1 along a and b.
Vec3d on_cube(int side, double a, double b) {
  const double out = side % 2 == 0 ? 1 : -1;
  Vec3d point;
  point[side / 2] = out;
  point[(side / 2 + 1) % 3] = a * out;
  point[(side / 2 + 2) % 3] = b;
  return point;
}

double radius_along(const Vec3d& direction) {
  return 1 + 0.03 * std::sin(5 * direction.x()) * std::cos(4 * direction.y() + direction.z());
}

uint8_t wave_byte(double phase) {
  return static_cast<uint8_t>(std::lround(128 + 100 * std::sin(phase)));
}

/// Writes the vertices, coordinates and faces of an OBJ.
class BallWriter {
 public:
  explicit BallWriter(const PaintedBall& ball) : ball_(ball) {}

  std::string write() {
    for (int side = 0; side < 6; ++side) add_side(side);
    return "mtllib ball.mtl\n" + vertices_ + coordinates_ + "usemtl skin\n" + faces_;
  }

 private:
  void add_side(int side) {
    const int n = ball_.quads_per_side;
    std::vector<std::string> corners;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) corners.push_back(corner(side, i, j));
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const auto at = [&](int x, int y) { return corners[size_t(j + y) * (n + 1) + i + x]; };
        faces_ += "f " + at(0, 0) + ' ' + at(1, 0) + ' ' + at(1, 1) + "\n";
        faces_ += "f " + at(0, 0) + ' ' + at(1, 1) + ' ' + at(0, 1) + "\n";
      }
  }

  std::string corner(int side, int i, int j) {
    const int n = ball_.quads_per_side;
    const Vec3d cube = on_cube(side, 2.0 * i / n - 1, 2.0 * j / n - 1);
    const std::array<long, 3> key = {std::lround(cube.x() * n), std::lround(cube.y() * n),
                                     std::lround(cube.z() * n)};
    const auto [found, is_new] = numbers_.emplace(key, numbers_.size() + 1);
    if (is_new) {
      const Vec3d place = cube.normalized() * radius_along(cube.normalized());
      add(vertices_, "v %.9g %.9g %.9g\n", place.x(), place.y(), place.z());
    }
    const double cell = ball_.face_texels + 2;
    const double u = side % kFacesPerRow * cell + 1 + ball_.face_texels * double(i) / n;
    const double v = side / kFacesPerRow * cell + 1 + ball_.face_texels * double(j) / n;
    add(coordinates_, "vt %.9g %.9g\n", u / (kFacesPerRow * cell), 1 - v / (2 * cell), 0);
    return std::to_string(found->second) + '/' + std::to_string(++coordinate_count_);
  }

  static void add(std::string& text, const char* format, double a, double b, double c) {
    char line[100];
    std::snprintf(line, sizeof line, format, a, b, c);
    text += line;
  }

  const PaintedBall& ball_;
  std::string vertices_, coordinates_, faces_;
  std::map<std::array<long, 3>, size_t> numbers_;
  size_t coordinate_count_ = 0;
};

}  // namespace

Rgba8 PaintedBall::colour_at(const Vec3d& position) const {
  const Vec3d turn = position.normalized() * (2 * std::numbers::pi / wave);
  return {wave_byte(turn.x() + 0.3 * turn.y()), wave_byte(0.8 * turn.y() - 0.4 * turn.z()),
          wave_byte(0.6 * turn.z() + 0.5 * turn.x()), 255};
}

Picture PaintedBall::picture() const {
  const uint32_t cell = face_texels + 2;
  return drawn(kFacesPerRow * cell, 2 * cell, [&](uint32_t x, uint32_t y) {
    const int side = static_cast<int>(y / cell * kFacesPerRow + x / cell);
    const auto part = [&](uint32_t at) { return 2 * ((at % cell) - 0.5) / face_texels - 1; };
    return colour_at(on_cube(side, part(x), part(y)));
  });
}

std::string PaintedBall::obj() const {
  return BallWriter(*this).write();
}

std::vector<uint8_t> PaintedBall::zip(const std::string& png) const {
  return zip_of(obj(), png);
}

std::vector<uint8_t> PaintedBall::zip() const {
  return zip(png_of(picture()));
}

std::vector<uint8_t> zip_of(const std::string& obj, const std::string& png) {
  const std::vector<uint8_t> mesh = bytes_of(obj);
  const std::vector<uint8_t> material = bytes_of(std::string("newmtl skin\nmap_Kd skin.png\n"));
  const std::vector<uint8_t> skin = bytes_of(png);
  const std::vector<FileToPack> files = {
      {"ball.obj", mesh}, {"ball.mtl", material}, {"skin.png", skin}};
  return pack_archive(files).value();
}

std::vector<uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

}  // namespace burnish

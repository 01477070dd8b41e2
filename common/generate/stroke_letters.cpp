#include "common/generate/stroke_letters.h"

#include <algorithm>

namespace burnish {
namespace {

using Vec2d = Eigen::Vector2d;

Polyline mirrored(Polyline line, double x) {
  for (Vec2d& p : line) p.x() = 2 * x - p.x();
  return line;
}

Polyline reversed(Polyline line) {
  std::reverse(line.begin(), line.end());
  return line;
}

Polyline joined(Polyline first, const Polyline& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Returns the stem and the bowl of P and R.
Polyline bowl() {
  Polyline bowl = half_circle({0.32, 0.755}, 0.245, 8);
  bowl.insert(bowl.begin(), Vec2d(0, 0.51));
  bowl.insert(bowl.end(), {Vec2d(0, 1), Vec2d(0, 0)});
  return bowl;
}

std::vector<Polyline> circle() {
  const Polyline right = half_circle({0.46, 0.5}, 0.46, 10);
  return {right, mirrored(right, 0.46)};
}

/// Returns a left half circle above a right one.
Polyline snake() {
  const Polyline above = mirrored(half_circle({0.28, 0.745}, 0.255, 8), 0.28);
  const Polyline below = half_circle({0.28, 0.255}, 0.255, 8);
  Polyline line = joined({{0.55, 1}}, reversed(above));
  line = joined(line, reversed(below));
  return joined(line, {{0, 0}});
}

/// Returns the strokes of a capital of height 1 on a base line at 0.
std::vector<Polyline> letter(char c) {
  switch (c) {
    case 'A':
      return {{{0, 0}, {0.36, 1}, {0.72, 0}}, {{0.14, 0.36}, {0.58, 0.36}}};
    case 'C':
      return {joined(joined({{0.7, 0}}, mirrored(half_circle({0.46, 0.5}, 0.5, 10), 0.46)),
                     {{0.7, 1}})};
    case 'E':
      return {{{0.55, 1}, {0, 1}, {0, 0}, {0.55, 0}}, {{0, 0.52}, {0.45, 0.52}}};
    case 'H':
      return {{{0, 0}, {0, 1}}, {{0.66, 0}, {0.66, 1}}, {{0, 0.52}, {0.66, 0.52}}};
    case 'I':
      return {{{0.1, 0}, {0.1, 1}}};
    case 'M':
      return {{{0, 0}, {0.06, 1}, {0.43, 0.2}, {0.8, 1}, {0.86, 0}}};
    case 'O':
      return circle();
    case 'P':
      return {bowl()};
    case 'Q': {
      std::vector<Polyline> strokes = circle();
      strokes.push_back({{0.5, 0.3}, {0.95, -0.1}});
      return strokes;
    }
    case 'R':
      return {bowl(), {{0.3, 0.51}, {0.64, 0}}};
    case 'S':
      return {snake()};
    case 'X':
      return {{{0, 0}, {0.66, 1}}, {{0, 1}, {0.66, 0}}};
  }
  return {};
}

}  // namespace

Polyline half_circle(const Vec2d& centre, double radius, int pieces) {
  Polyline points;
  for (int i = 0; i <= pieces; ++i) {
    const double t = 2.0 * i / pieces - 1;  // tangent of half the angle
    points.push_back(centre + radius * Vec2d(1 - t * t, 2 * t) / (1 + t * t));
  }
  return points;
}

std::vector<Polyline> strokes_of(std::string_view text, Vec2d at, double height, double gap) {
  std::vector<Polyline> strokes;
  for (const char c : text) {
    double width = 0;
    for (Polyline stroke : letter(c)) {
      for (Vec2d& p : stroke) {
        width = std::max(width, p.x());
        p = at + height * p;
      }
      strokes.push_back(std::move(stroke));
    }
    at.x() += height * (width + gap);
  }
  return strokes;
}

double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

}  // namespace burnish

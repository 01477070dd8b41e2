#include "common/generate/tablet_plan.h"

#include <algorithm>
#include <string_view>

namespace burnish {
namespace {

using Vec2d = Eigen::Vector2d;
using Polyline = std::vector<Vec2d>;

const Vec2d kInscriptionAt(-140, -72);
constexpr double kInscriptionHeight = 34, kInscriptionWidth = 188;

struct Chisel {
  double half_width, depth;
};
constexpr Chisel kWall{4.2, 3.6}, kThin{3.0, 2.4}, kLetter{3.4, 2.8}, kDrill{5.2, 4.0};

/// Draws the right half of a circle from below to above; without libm, see noise.h.
Polyline half_circle(const Vec2d& centre, double radius, int pieces) {
  Polyline points;
  for (int i = 0; i <= pieces; ++i) {
    const double t = 2.0 * i / pieces - 1;  // tangent of half the angle
    points.push_back(centre + radius * Vec2d(1 - t * t, 2 * t) / (1 + t * t));
  }
  return points;
}

Polyline mirrored(Polyline line, double x) {
  for (Vec2d& p : line) p.x() = 2 * x - p.x();
  return line;
}

/// Returns the strokes of a capital of height 1 on a base line at 0. Knows only the letters of the
/// inscription.
std::vector<Polyline> letter(char c) {
  switch (c) {
    case 'A':
      return {{{0, 0}, {0.36, 1}, {0.72, 0}}, {{0.14, 0.36}, {0.58, 0.36}}};
    case 'E':
      return {{{0.55, 1}, {0, 1}, {0, 0}, {0.55, 0}}, {{0, 0.52}, {0.45, 0.52}}};
    case 'H':
      return {{{0, 0}, {0, 1}}, {{0.66, 0}, {0.66, 1}}, {{0, 0.52}, {0.66, 0.52}}};
    case 'O': {
      const Polyline right = half_circle({0.46, 0.5}, 0.46, 10);
      return {right, mirrored(right, 0.46)};
    }
    case 'R': {
      Polyline bowl = half_circle({0.32, 0.755}, 0.245, 8);
      bowl.insert(bowl.begin(), Vec2d(0, 0.51));
      bowl.insert(bowl.end(), {Vec2d(0, 1), Vec2d(0, 0)});
      return {bowl, {{0.3, 0.51}, {0.64, 0}}};
    }
  }
  return {};
}

/// Collects grooves; every call draws one part of the plan.
class Draughtsman {
 public:
  void line(const Chisel& chisel, const Polyline& points) {
    for (size_t i = 1; i < points.size(); ++i)
      grooves_.push_back({points[i - 1], points[i], chisel.half_width, chisel.depth});
  }
  void rectangle(const Chisel& chisel, double left, double bottom, double right, double top) {
    line(chisel, {{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}});
  }
  void columns(Vec2d from, const Vec2d& step, int count) {
    for (; count > 0; --count, from += step)
      grooves_.push_back({from, from, kDrill.half_width, kDrill.depth});
  }
  /// Draws a row of shops with a closed back; towards the street each shop has a door.
  void shops(double left, double front, double back, double width, int count) {
    line(kWall, {{left, back}, {left + count * width, back}});
    for (int i = 0; i <= count; ++i)
      line(kWall, {{left + i * width, front}, {left + i * width, back}});
    for (int i = 0; i < count; ++i) {
      const double x = left + i * width;
      line(kWall, {{x, front}, {x + 0.3 * width, front}});
      line(kWall, {{x + 0.7 * width, front}, {x + width, front}});
    }
  }
  void stairs(double left, double bottom, double right, double top, int treads) {
    rectangle(kThin, left, bottom, right, top);
    for (int i = 1; i < treads; ++i) {
      const double y = bottom + (top - bottom) * i / treads;
      line(kThin, {{left, y}, {right, y}});
    }
  }
  void inscription(std::string_view text, Vec2d at, double height) {
    constexpr double kGap = 0.28;  // between letters, of the height
    for (char c : text) {
      double width = 0;
      for (Polyline stroke : letter(c)) {
        for (Vec2d& p : stroke) {
          width = std::max(width, p.x());
          p = at + height * p;
        }
        line(kLetter, stroke);
      }
      at.x() += height * (width + kGap);
    }
  }
  std::vector<Groove> grooves() const { return grooves_; }

 private:
  std::vector<Groove> grooves_;
};

}  // namespace

std::vector<Groove> tablet_plan() {
  Draughtsman plan;
  plan.shops(-376, 92, 160, 62, 12);
  plan.line(kThin, {{-400, 184}, {400, 184}});
  plan.line(kWall, {{-400, 58}, {-40, 58}});  // the courtyard's front, with its gate
  plan.line(kWall, {{0, 58}, {400, 58}});
  plan.line(kWall, {{-190, 58}, {-190, -168}, {96, -168}, {96, 58}});
  plan.columns({-162, 30}, {29.5, 0}, 9);
  plan.columns({-162, -140}, {29.5, 0}, 9);
  plan.columns({-162, 2}, {0, -28.4}, 5);
  plan.columns({74, 2}, {0, -28.4}, 5);
  plan.inscription("HORREA", kInscriptionAt, kInscriptionHeight);
  plan.rectangle(kThin, -110, -118, 16, -92);
  plan.line(kWall, {{96, -20}, {196, -20}, {196, -26}});
  plan.line(kWall, half_circle({196, -74}, 48, 24));
  plan.line(kWall, {{196, -122}, {196, -128}, {96, -128}});
  plan.columns({122, -50}, {28, 0}, 3);
  plan.columns({122, -98}, {28, 0}, 3);
  plan.stairs(-244, -128, -208, -12, 9);
  plan.line(kWall, {{-400, -168}, {-190, -168}});
  plan.line(kWall, {{-260, 58}, {-260, -168}});
  plan.line(kWall, {{-400, -40}, {-260, -40}});
  plan.shops(-314, -260, -192, 62, 11);
  return plan.grooves();
}

Eigen::AlignedBox2d inscription_box() {
  const Vec2d margin = Vec2d::Constant(2 * kLetter.half_width);
  const Vec2d size(kInscriptionWidth, kInscriptionHeight);
  return {kInscriptionAt - margin, kInscriptionAt + size + margin};
}

static double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

double groove_depth(const std::vector<Groove>& grooves, const Vec2d& p) {
  double depth = 0;
  for (const Groove& groove : grooves) {
    const Vec2d reach = Vec2d::Constant(groove.half_width);
    const Vec2d low = groove.from.cwiseMin(groove.to) - reach;
    const Vec2d high = groove.from.cwiseMax(groove.to) + reach;
    if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) continue;
    const double distance = distance_to_segment(p, groove.from, groove.to);
    depth = std::max(depth, groove.depth * (1 - distance / groove.half_width));
  }
  return depth;
}

}  // namespace burnish

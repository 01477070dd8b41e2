#include "common/generate/tablet_plan.h"

#include <algorithm>
#include <string_view>

#include "common/generate/stroke_letters.h"

namespace burnish {
namespace {

using Vec2d = Eigen::Vector2d;

const Vec2d kInscriptionAt(-140, -72);
constexpr double kInscriptionHeight = 34, kInscriptionWidth = 188;

struct Chisel {
  double half_width, depth;
};
constexpr Chisel kWall{4.2, 3.6}, kThin{3.0, 2.4}, kLetter{3.4, 2.8}, kDrill{5.2, 4.0};

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
  void inscription(std::string_view text, const Vec2d& at, double height) {
    constexpr double kGap = 0.28;  // between letters, of the height
    for (const Polyline& stroke : strokes_of(text, at, height, kGap)) line(kLetter, stroke);
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

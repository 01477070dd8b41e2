#include <algorithm>
#include <cmath>
#include <string_view>

#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"
#include "common/generate/stroke_letters.h"

namespace burnish {
namespace {

using Vec2d = Eigen::Vector2d;

// A struck coin as a height field over the unit square: a dome, a raised rim, and lines of letters
// that rise less and less.
constexpr double kReliefHeight = 0.035, kDomeHeight = 0.06;
constexpr double kRimInside = 0.41875, kRimOutside = 0.475;
constexpr double kFlankWidth = 0.0165;
constexpr double kLetterGap = 0.45;  // of the height: strokes are bold

struct TextLine {
  std::string_view text;
  double left, base, height, half_stroke;
  double level;  // of the relief's height
};
constexpr TextLine kLines[] = {{"SPQR", 0.2, 0.6, 0.15, 0.018, 1},
                               {"CAESAR", 0.29, 0.41, 0.07, 0.0085, 0.78},
                               {"MMXI", 0.37, 0.26, 0.07, 0.0085, 0.55}};

struct Stroke {
  Vec2d from, to;
  double half_width, level;
};

std::vector<Stroke> coin_strokes() {
  std::vector<Stroke> strokes;
  for (const TextLine& line : kLines)
    for (const Polyline& points :
         strokes_of(line.text, {line.left, line.base}, line.height, kLetterGap))
      for (size_t i = 1; i < points.size(); ++i)
        strokes.push_back({points[i - 1], points[i], line.half_stroke, line.level});
  return strokes;
}

/// Returns 0 to 1 across a flank whose middle lies at 0.
double flank(double inside) {
  const double t = std::clamp(inside / kFlankWidth + 0.5, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double relief(const std::vector<Stroke>& strokes, const Vec2d& p) {
  const double from_middle = (p - Vec2d(0.5, 0.5)).norm();
  double height = flank(std::min(from_middle - kRimInside, kRimOutside - from_middle));
  for (const Stroke& stroke : strokes) {
    const double inside = stroke.half_width - distance_to_segment(p, stroke.from, stroke.to);
    height = std::max(height, stroke.level * flank(inside));
  }
  return height;
}

}  // namespace

TriangleMesh generate_coin(const GeneratedScan& wanted) {
  const int side = lattice_size(std::sqrt(static_cast<double>(wanted.vertices)), 2);
  const std::vector<Stroke> strokes = coin_strokes();
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<size_t>(side) * side);
#pragma omp parallel for
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const Vec2d p = Vec2d(column, row) / (side - 1);
      const double dome = kDomeHeight * (1 - 2 * (p - Vec2d(0.5, 0.5)).squaredNorm());
      mesh.vertices[static_cast<size_t>(row) * side + column] =
          Vec3d(p.x(), p.y(), dome + kReliefHeight * relief(strokes, p));
    }
  add_lattice_quads(mesh, 0, side, side);
  mesh.has_double_positions = true;
  return mesh;
}

}  // namespace burnish

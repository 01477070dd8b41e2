#include "server/prepare/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/base/limits.h"

namespace burnish {

namespace {

constexpr size_t kProbesMin = 256, kProbesMax = 1024;
constexpr size_t kTrianglesPerProbe = 128, kTrianglesSeen = 65536;
constexpr double kFacesAway = -0.3;  // cosine between normals: an edge of a part is no wall
constexpr double kDoubled = 0.01;  // cells: what is nearer is one face twice, or a neighbour's edge
constexpr double kRounding = 1e-3;  // a wall of one cell is not thinner than it
constexpr double kLeftMax = 0.1;    // of the thin walls, at the depth that is told

/// A place on the surface.
struct Probe {
  uint32_t triangle;
  Vec3d at;
};

Vec3d twice_area_of(const std::array<Vec3d, 3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

// Consecutive numbers are spread evenly over a triangle.
Vec3d place_on(const std::array<Vec3d, 3>& corners, size_t number) {
  const auto part = [&](double step) {
    return std::fmod(0.5 + static_cast<double>(number) * step, 1.0);
  };
  const double across = std::sqrt(part(0.7548776662466927)), along = part(0.5698402909980532);
  const Vec3d far = corners[1] + along * (corners[2] - corners[1]);
  return corners[0] + across * (far - corners[0]);
}

// A scan with many triangles is seen by some of them: an odd step meets both of each quad.
std::vector<Probe> place_probes(const GridMesh& mesh, double area) {
  const size_t count = mesh.triangles.size(), step = count / kTrianglesSeen | 1;
  const size_t probes_max = std::clamp(count / kTrianglesPerProbe, kProbesMin, kProbesMax);
  const double apart = 2 * area / static_cast<double>(probes_max * step);
  std::vector<Probe> probes;
  double next = apart / 2, sum = 0;
  for (size_t t = 0; t < count; t += step) {
    const auto corners = mesh.corners(static_cast<uint32_t>(t));
    sum += twice_area_of(corners).norm();
    for (; next < sum && probes.size() < 2 * probes_max; next += apart)
      probes.push_back({static_cast<uint32_t>(t), place_on(corners, probes.size())});
  }
  return probes;
}

/// Returns where the line from a place meets a triangle, in lengths of `way`; infinity if nowhere.
double distance_to(const std::array<Vec3d, 3>& corners, const Vec3d& from, const Vec3d& way) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  const Vec3d u = corners[1] - corners[0], v = corners[2] - corners[0], normal = u.cross(v);
  const double along = normal.dot(way);
  if (along == 0) return kNowhere;
  const Vec3d start = from - corners[0], across = start.cross(way);
  const double a = -v.dot(across) / along, b = u.dot(across) / along;
  return a < 0 || b < 0 || a + b > 1 ? kNowhere : -normal.dot(start) / along;
}

// Returns 1 if there is no wall, or a thicker one. Units: cells. A cell may have most of the
// pieces.
double thickness_at(const Probe& probe, const Surface& surface, std::span<const CellPiece> pieces,
                    double inwards, LoopProgress& loop) {
  const Vec3d normal = surface.curvature.normal_of(probe.triangle);
  const Vec3d way = inwards * normal, end = probe.at + way;
  const Vec3i low = probe.at.cwiseMin(end).cwiseMax(0).cast<int>();
  const Vec3i high = probe.at.cwiseMax(end).cwiseMax(0).cast<int>();
  double thickness = 1 - kRounding;
  size_t met = 0;
  const auto meet = [&](uint32_t triangle) {
    const double distance = distance_to(surface.mesh.corners(triangle), probe.at, way);
    if (distance > kDoubled && distance < thickness &&
        surface.curvature.normal_of(triangle).dot(normal) < kFacesAway)
      thickness = distance;
  };
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i)
        for (const CellPiece& piece :
             std::ranges::equal_range(pieces, morton_key({i, j, k}), {}, &CellPiece::cell)) {
          if (++met % kHeardBlock == 0 && !loop.goes_on(0)) return thickness;
          meet(piece.triangle);
        }
  return thickness;
}

}  // namespace

ThinWalls find_thin_walls(const Surface& surface, std::span<const CellPiece> pieces, double area,
                          bool is_inside_out, const LoopPart& part) {
  const std::vector<Probe> probes = place_probes(surface.mesh, area);
  std::vector<double> thickness(probes.size());
  LoopProgress loop(part.progress, part.phase, part.begin, part.begin);
  ask_before(loop);
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < probes.size(); ++i)
    if (loop.goes_on(0))
      thickness[i] = thickness_at(probes[i], surface, pieces, is_inside_out ? 1 : -1, loop);
  leave_if_cancelled(loop);
  const auto share_below = [&](double cells) {
    const auto below =
        std::ranges::count_if(thickness, [&](double t) { return t < cells * (1 - kRounding); });
    return static_cast<double>(below) / static_cast<double>(probes.size());
  };
  ThinWalls walls = {share_below(1), surface.mesh.depth};
  if (!(walls.share >= kThinWallShareMin)) return {};
  double cell = 1;
  do {
    cell /= 2;
    if (++walls.depth > kDepthMax) return {walls.share, 0};
  } while (share_below(cell) > kLeftMax * walls.share);
  return walls;
}

}  // namespace burnish

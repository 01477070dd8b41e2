#include "server/prepare/pages/kd_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "common/base/limits.h"
#include "server/prepare/pages/local_vertices.h"

namespace burnish {

namespace {

constexpr size_t kTaskTriangles = 16384;  // for fewer, waking a thread takes longer

/// Returns the sides of the box around a piece's centres, three times as long.
std::array<double, 3> sides_of(std::span<const TriangleCentre> piece) {
  std::array<int32_t, 3> low = piece[0].at, high = piece[0].at;
  for (const TriangleCentre& centre : piece)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], centre.at[axis]);
      high[axis] = std::max(high[axis], centre.at[axis]);
    }
  std::array<double, 3> sides;
  for (int axis = 0; axis < 3; ++axis) sides[axis] = double(high[axis]) - low[axis];
  return sides;
}

/// Returns the mean sides of a piece's triangles, three times as long.
Vec3d mean_sides(std::span<const TriangleCentre> piece, const KdRule& rule) {
  Vec3d sum = Vec3d::Zero();
  for (const TriangleCentre& centre : piece) {
    const auto& [a, b, c] = rule.triangles[centre.triangle];
    const Vec3i &p = rule.positions[a], &q = rule.positions[b], &r = rule.positions[c];
    sum += (p.cwiseMax(q).cwiseMax(r) - p.cwiseMin(q).cwiseMin(r)).cast<double>();
  }
  return 3 * sum / static_cast<double>(piece.size());
}

/// Returns the area of a triangle, steps².
double triangle_area(const TriangleCentre& centre, const KdRule& rule) {
  const auto& [a, b, c] = rule.triangles[centre.triangle];
  const Vec3d origin = rule.positions[a].cast<double>();
  const Vec3d along = rule.positions[b].cast<double>() - origin;
  const Vec3d across = rule.positions[c].cast<double>() - origin;
  return std::max(along.cross(across).norm() / 2, kTriangleAreaMin);
}

/// Returns the axis of the longest side. Where texels matter, pieces are small, and are not cut
/// across their triangles: needles that alternate, as in strips, would lose the neighbours with
/// which they share their sides.
int axis_to_cut(std::span<const TriangleCentre> piece, const KdRule& rule) {
  std::array<double, 3> sides = sides_of(piece);
  if (rule.texels.matter()) {
    const Vec3d of_triangles = mean_sides(piece, rule);
    for (int axis = 0; axis < 3; ++axis) sides[axis] -= of_triangles[axis];
  }
  return static_cast<int>(std::ranges::max_element(sides) - sides.begin());
}

}  // namespace

bool KdCut::fits_page(std::span<const TriangleCentre> piece) const {
  if (piece.size() > kPageTrianglesMax) return false;
  LocalVertices locals;
  for (const TriangleCentre& centre : piece)
    for (const uint32_t v : rule_.triangles[centre.triangle])
      if (locals.add(v) == LocalVertices::kFull) return false;
  return fits_sheet(piece);
}

bool KdCut::fits_sheet(std::span<const TriangleCentre> piece) const {
  if (!rule_.texels.matter() || piece.size() == 1) return true;
  double texels = 0;
  for (const TriangleCentre& centre : piece) texels += rule_.texels.of_triangle[centre.triangle];
  return texels <= rule_.texels.of_page_max &&
         (!rule_.keeps_dense_parts || fits_dense_parts(piece));
}

/// A page has one density. Its sheet has room for twice as many texels as pages show of pictures
/// that are equally dense everywhere.
bool KdCut::fits_dense_parts(std::span<const TriangleCentre> piece) const {
  constexpr double kRoom = 2;
  double area = 0;
  std::vector<TexelsOnArea> shown;
  for (const TriangleCentre& centre : piece) {
    const double of_triangle = triangle_area(centre, rule_);
    area += of_triangle;
    const double texels = rule_.texels.of_triangle[centre.triangle];
    if (texels > 0) shown.push_back({texels, of_triangle});
  }
  const double density = needed_texel_density(std::move(shown));
  return area * density * density <= kRoom * rule_.texels.of_page_max;
}

// Gives the first part a whole number of pages, so that pages come out full. Two pages have room to
// move the cut between them.
size_t KdCut::size_of_first_part(size_t size) const {
  const double wanted = static_cast<double>(rule_.triangles_wanted);
  const double pages = std::max(2.0, std::ceil(size / wanted));
  double part = std::clamp(std::round(pages * rule_.ratio), 1.0, pages - 1) / pages;
  if (pages == 2) {
    const double room = std::clamp(wanted / size, 0.5, 1.0);
    part = std::clamp(rule_.ratio, 1 - room, room);
  }
  return std::clamp<size_t>(static_cast<size_t>(size * part), 1, size - 1);
}

void KdCut::split(size_t begin, size_t end) const {
  if (!loop_.goes_on(0)) return;
  const std::span<TriangleCentre> piece = centres_.subspan(begin, end - begin);
  if (fits_page(piece)) {
    std::ranges::sort(piece, {}, &TriangleCentre::triangle);
    is_start_[begin] = 1;
    return;
  }
  const int axis = axis_to_cut(piece, rule_);
  const size_t first = size_of_first_part(piece.size());
  std::ranges::nth_element(piece, piece.begin() + first,
                           [axis](const TriangleCentre& a, const TriangleCentre& b) {
                             if (a.at[axis] != b.at[axis]) return a.at[axis] < b.at[axis];
                             return a.triangle < b.triangle;
                           });
  const size_t middle = begin + first;
#pragma omp task if (piece.size() > kTaskTriangles) firstprivate(begin, middle)
  split(begin, middle);
#pragma omp task if (piece.size() > kTaskTriangles) firstprivate(middle, end)
  split(middle, end);
}

}  // namespace burnish

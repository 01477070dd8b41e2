#include "server/fields/held_lines.h"

#include <algorithm>
#include <cmath>

#include "server/fields/cell_layers.h"

namespace burnish {
namespace {

struct GaussPoint {
  double at, weight;  // on 0..1
};
// Exact to degree 7. Products of two trilinear functions have degree 6 along a line.
constexpr std::array<GaussPoint, 4> kGauss = {{{0.06943184420297371, 0.17392742256872692},
                                               {0.33000947820757187, 0.32607257743127308},
                                               {0.66999052179242813, 0.32607257743127308},
                                               {0.93056815579702629, 0.17392742256872692}}};

// Returns where a line from `from` to `to` meets grid planes, with both ends: rising parts of its
// length.
std::vector<double> cuts_at_planes(const Vec3d& from, const Vec3d& to) {
  std::vector<double> cuts = {0, 1};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::min(from[axis], to[axis]), high = std::max(from[axis], to[axis]);
    for (double plane = std::floor(low) + 1; plane < high; ++plane)
      cuts.push_back((plane - from[axis]) / (to[axis] - from[axis]));
  }
  std::ranges::sort(cuts);
  return cuts;
}

void add_point(const Vec3d& local, double weight, LineMass& line) {
  std::array<double, kCornersPerCell> basis;
  basis.fill(1);
  for (int a = 0; a < kCornersPerCell; ++a)
    for (int axis = 0; axis < 3; ++axis)
      basis[a] *= (a >> axis & 1) != 0 ? local[axis] : 1 - local[axis];
  int pair = 0;
  for (int a = 0; a < kCornersPerCell; ++a) {
    line.row_sum[a] += weight * basis[a];
    for (int b = a + 1; b < kCornersPerCell; ++b) line.pair[pair++] += weight * basis[a] * basis[b];
  }
}

void add_up(const LineMass& part, LineMass& sum) {
  for (int pair = 0; pair < kPairsPerCell; ++pair) sum.pair[pair] += part.pair[pair];
  for (int a = 0; a < kCornersPerCell; ++a) sum.row_sum[a] += part.row_sum[a];
}

bool has_sheets(const PreparedMesh& prepared, int32_t cell) {
  const auto found = std::ranges::lower_bound(prepared.sheets, cell, {}, &CellSheet::cell);
  return found != prepared.sheets.end() && found->cell == cell;
}

}  // namespace

void HeldLines::add(const Vec3d& from, const Vec3d& to) {
  const std::vector<double> cuts = cuts_at_planes(from, to);
  const double length = (to - from).norm();
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double part = cuts[i + 1] - cuts[i];
    if (!(part * length > 0)) continue;
    const Vec3d middle = from + (cuts[i] + part / 2) * (to - from);
    const Vec3i place = middle.array().floor().cast<int>();
    const int32_t cell = find_cell(prepared_, place);
    if (cell == kNone || has_sheets(prepared_, cell)) continue;
    LineMass& line = parts_.emplace_back(LineMass{.cell = cell});
    for (const auto& [at, weight] : kGauss) {
      const Vec3d point = from + (cuts[i] + at * part) * (to - from);
      add_point((point - place.cast<double>()).cwiseMax(0.0).cwiseMin(1.0), weight * part * length,
                line);
    }
  }
}

std::vector<LineMass> HeldLines::take() {
  std::ranges::stable_sort(parts_, {}, &LineMass::cell);
  std::vector<LineMass> lines;
  for (const LineMass& part : parts_) {
    if (!lines.empty() && lines.back().cell == part.cell)
      add_up(part, lines.back());
    else
      lines.push_back(part);
  }
  parts_ = {};
  lines.shrink_to_fit();
  return lines;
}

std::vector<int32_t> first_lines(std::span<const LineMass> lines, size_t cells) {
  std::vector<int32_t> first((cells + LineView::kStretch - 1) / LineView::kStretch + 1, 0);
  for (const LineMass& line : lines) ++first[line.cell / LineView::kStretch + 1];
  for (size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  return first;
}

}  // namespace burnish

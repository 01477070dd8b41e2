#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/pages/page.h"

namespace burnish {

using Vec2d = Eigen::Vector2d;

/// A part of a page's triangles, projected along one direction without overlap. Texels lie on the
/// plane of the axes u and v.
struct Chart {
  std::array<int16_t, 2> normal = {};  ///< an octahedral code of limit kChartNormalLimit
  uint16_t angle = 0;                  ///< of u around the normal, 2^16 a turn
  std::array<int32_t, 2> least = {};   ///< u and v of the chart's corner, steps of PageGrid

  bool operator==(const Chart&) const = default;
};
inline constexpr int kChartNormalLimit = 32767;

/// The charts of one page. They are numbered by their first triangles.
struct PageCharts {
  std::vector<Chart> charts;
  std::vector<uint16_t> of_triangle;  ///< one per triangle of the page

  bool operator==(const PageCharts&) const = default;
};

/// Unit vectors, right-handed: u × v is the normal.
struct ChartAxes {
  Vec3d u;
  Vec3d v;
  Vec3d normal;
};

/// Returns the axes that a chart's codes mean. An angle of 0 stands for the first tangent of Duff
/// et al., "Building an Orthonormal Basis, Revisited" (2017).
ChartAxes axes_of(const Chart& chart);

/// Sizes of a chart's projection from its corner on, steps of PageGrid.
struct ChartExtent {
  double u = 0;
  double v = 0;
};

/// Returns the extent of each chart. Needs: charts of this page.
std::vector<ChartExtent> chart_extents(const Page& page, const PageCharts& charts);

/// Checks that each triangle has a chart and each chart a triangle, that charts are numbered by
/// their first triangles, and that none begins after one of its vertices.
/// Fails: invalid_argument that names the chart, its value and its limit.
Status check_charts(const Page& page, const PageCharts& charts);

}  // namespace burnish

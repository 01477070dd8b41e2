#include "client/gl/chart_order.h"

#include <algorithm>
#include <numeric>

namespace burnish {

static void add_runs(const PageTexture& texture, uint32_t first, uint32_t end, ChartOrder& order) {
  for (uint32_t i = first; i < end; ++i) {
    const uint16_t chart = texture.chart_of_triangle[order.triangles[i]];
    if (i == first || order.runs.back().chart != chart) order.runs.push_back({i, 0, chart});
    ++order.runs.back().count;
  }
}

ChartOrder chart_order(const PageTexture& texture) {
  ChartOrder order;
  order.triangles.resize(texture.chart_of_triangle.size());
  std::iota(order.triangles.begin(), order.triangles.end(), uint16_t{0});
  uint32_t first = 0;
  for (const uint32_t end : texture.patch_ends) {
    std::stable_sort(order.triangles.begin() + first, order.triangles.begin() + end,
                     [&](uint16_t one, uint16_t other) {
                       return texture.chart_of_triangle[one] < texture.chart_of_triangle[other];
                     });
    add_runs(texture, first, end, order);
    first = end;
  }
  return order;
}

}  // namespace burnish

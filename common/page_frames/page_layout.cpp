#include "common/page_frames/page_layout.h"

#include <algorithm>
#include <vector>

namespace burnish {

namespace {

// Adds the predictors of the next value.
void add_predictors(std::vector<uint16_t>& earlier, PageLayout& layout) {
  const uint32_t value = layout.value_count();
  std::ranges::sort(earlier);
  earlier.erase(std::ranges::unique(earlier).begin(), earlier.end());
  if (earlier.empty() && value > 0) earlier.push_back(static_cast<uint16_t>(value - 1));
  layout.predictors.add(earlier);
}

Groups<uint16_t> earlier_neighbours(const Page& page) {
  return group_by<uint16_t>(page.positions.size(), [&page](auto&& add) {
    for (const PageTriangle& triangle : page.triangles)
      for (const uint16_t vertex : triangle)
        for (const uint16_t other : triangle)
          if (other < vertex) add(vertex, other);
  });
}

}  // namespace

PageLayout make_vertex_page_layout(const Page& page) {
  const Groups<uint16_t> earlier = earlier_neighbours(page);
  PageLayout layout;
  layout.vertices = static_cast<uint32_t>(page.positions.size());
  std::vector<uint16_t> predictors;
  for (size_t vertex = 0; vertex < page.positions.size(); ++vertex) {
    predictors.assign(earlier[vertex].begin(), earlier[vertex].end());
    add_predictors(predictors, layout);
  }
  return layout;
}

PageLayout make_corner_page_layout(const PageCorners& corners) {
  PageLayout layout;
  layout.vertices = static_cast<uint32_t>(corners.of_vertex.size());
  std::vector<uint16_t> predictors;
  for (const MortonKey place : corners.places) {
    predictors.clear();
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3i below = morton_point(place) - Vec3i::Unit(axis);
      if (below[axis] < 0) continue;
      const auto at = std::ranges::lower_bound(corners.places, morton_key(below));
      if (*at == morton_key(below))
        predictors.push_back(static_cast<uint16_t>(at - corners.places.begin()));
    }
    add_predictors(predictors, layout);
  }
  return layout;
}

}  // namespace burnish

#include "common/sheets/facet_graph.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace burnish {

namespace {

/// Returns for each vertex a number that those at the same position share.
std::vector<uint16_t> place_numbers(const Page& page) {
  std::vector<uint16_t> order(page.positions.size());
  std::iota(order.begin(), order.end(), uint16_t{0});
  const auto place = [&page](uint16_t v) {
    const Vec3i& p = page.positions[v];
    return std::tuple(p.x(), p.y(), p.z());
  };
  std::ranges::sort(order, {}, [&](uint16_t v) { return std::tuple(place(v), v); });
  std::vector<uint16_t> numbers(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && place(order[i]) == place(order[i - 1]);
    numbers[order[i]] = is_same ? numbers[order[i - 1]] : order[i];
  }
  return numbers;
}

struct FacetSide {
  uint16_t low;
  uint16_t high;
  uint16_t triangle;
  auto operator<=>(const FacetSide&) const = default;
  bool meets(const FacetSide& other) const { return low == other.low && high == other.high; }
};

std::vector<FacetSide> sorted_sides(const Page& page) {
  const std::vector<uint16_t> number = place_numbers(page);
  std::vector<FacetSide> sides;
  for (size_t t = 0; t < page.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const uint16_t a = number[page.triangles[t][k]];
      const uint16_t b = number[page.triangles[t][(k + 1) % 3]];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<uint16_t>(t)});
    }
  std::ranges::sort(sides);
  return sides;
}

}  // namespace

FacetGraph facet_graph(const Page& page) {
  FacetGraph graph;
  for (const PageTriangle& triangle : page.triangles) {
    const Vec3d a = page.positions[triangle[0]].cast<double>();
    const Vec3d b = page.positions[triangle[1]].cast<double>();
    const Vec3d c = page.positions[triangle[2]].cast<double>();
    graph.area_vectors.emplace_back((b - a).cross(c - a));
    const double length = graph.area_vectors.back().norm();
    graph.normals.emplace_back(length > 0 ? Vec3d(graph.area_vectors.back() / length)
                                          : Vec3d(Vec3d::Zero()));
  }
  const std::vector<FacetSide> sides = sorted_sides(page);
  graph.neighbours = group_by<uint16_t>(page.triangles.size(), [&](auto&& add_one) {
    for (size_t i = 1; i < sides.size(); ++i) {
      if (!sides[i].meets(sides[i - 1])) continue;
      add_one(sides[i].triangle, sides[i - 1].triangle);
      add_one(sides[i - 1].triangle, sides[i].triangle);
    }
  });
  return graph;
}

}  // namespace burnish

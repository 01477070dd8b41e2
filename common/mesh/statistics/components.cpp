#include "common/mesh/statistics/components.h"

#include "common/base/disjoint_sets.h"

namespace burnish {

void find_component_roots(std::span<const Triangle> triangles, std::span<int32_t> roots,
                          const LoopPart& part) {
  DisjointSetsIn sets(roots);
  for_each_heard(part.of(0, 0.8), triangles.size(), [&](size_t t) {
    const auto& [a, b, c] = triangles[t];
    sets.join(static_cast<int32_t>(a), static_cast<int32_t>(b));
    sets.join(static_cast<int32_t>(b), static_cast<int32_t>(c));
  });
  for_each_heard(part.of(0.8, 1), roots.size(),
                 [&](size_t v) { roots[v] = sets.root(static_cast<int32_t>(v)); });
}

std::vector<int32_t> component_roots(std::span<const Triangle> triangles, size_t vertices) {
  std::vector<int32_t> roots(vertices);
  find_component_roots(triangles, roots);
  return roots;
}

}  // namespace burnish

#include "common/mesh/components.h"

#include "common/base/disjoint_sets.h"

namespace burnish {

void find_component_roots(std::span<const Triangle> triangles, std::span<int32_t> roots) {
  DisjointSetsIn sets(roots);
  for (const Triangle& t : triangles) {
    sets.join(static_cast<int32_t>(t[0]), static_cast<int32_t>(t[1]));
    sets.join(static_cast<int32_t>(t[1]), static_cast<int32_t>(t[2]));
  }
  for (size_t v = 0; v < roots.size(); ++v) roots[v] = sets.root(static_cast<int32_t>(v));
}

std::vector<int32_t> component_roots(std::span<const Triangle> triangles, size_t vertices) {
  std::vector<int32_t> roots(vertices);
  find_component_roots(triangles, roots);
  return roots;
}

}  // namespace burnish

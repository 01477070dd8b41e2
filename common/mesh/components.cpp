#include "common/mesh/components.h"

#include "common/base/disjoint_sets.h"

namespace burnish {

std::vector<int32_t> component_roots(std::span<const Triangle> triangles, size_t vertices) {
  DisjointSets sets(vertices);
  for (const Triangle& t : triangles) {
    sets.join(static_cast<int32_t>(t[0]), static_cast<int32_t>(t[1]));
    sets.join(static_cast<int32_t>(t[1]), static_cast<int32_t>(t[2]));
  }
  std::vector<int32_t> roots(vertices);
  for (size_t v = 0; v < vertices; ++v) roots[v] = sets.root(static_cast<int32_t>(v));
  return roots;
}

}  // namespace burnish

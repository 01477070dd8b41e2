#include "server/prepare/pages/kept_border.h"

#include <algorithm>

#include "common/base/sort_once.h"

namespace burnish {

// Sums the passes of every edge between locked vertices; edges inside the piece sum to nothing.
std::vector<KeptBorder::Edge> KeptBorder::edges_of(const std::vector<Triangle>& triangles) const {
  std::vector<Edge> edges;
  for (const Triangle& t : triangles)
    for (int corner = 0; corner < 3; ++corner) {
      const uint64_t from = t[corner], to = t[(corner + 1) % 3];
      if (piece_.locked[from] && piece_.locked[to])
        edges.push_back({std::min(from, to) << 32 | std::max(from, to), from < to ? 1 : -1});
    }
  std::ranges::sort(edges, {}, &Edge::ends);
  std::vector<Edge> summed;
  for (const Edge& edge : edges) {
    if (summed.empty() || summed.back().ends != edge.ends) summed.push_back({edge.ends, 0});
    summed.back().passes += edge.passes;
  }
  std::erase_if(summed, [](const Edge& edge) { return edge.passes == 0; });
  return summed;
}

KeptBorder::KeptBorder(const PagePiece& piece) : piece_(piece) {
  edges_ = edges_of(piece.triangles);
}

std::vector<uint32_t> KeptBorder::find_lost(const std::vector<Triangle>& simple) const {
  std::vector<uint32_t> lost;
  std::vector<uint8_t> is_there(piece_.vertices.size());
  for (const Triangle& t : simple)
    for (const uint32_t v : t) is_there[v] = 1;
  for (uint32_t v = 0; v < is_there.size(); ++v)
    if (piece_.locked[v] && !is_there[v]) lost.push_back(v);

  const std::vector<Edge> now = edges_of(simple);
  for (const Edge& edge : edges_) {
    const auto found = std::ranges::lower_bound(now, edge.ends, {}, &Edge::ends);
    if (found != now.end() && found->ends == edge.ends && found->passes == edge.passes) continue;
    lost.push_back(static_cast<uint32_t>(edge.ends >> 32));
    lost.push_back(static_cast<uint32_t>(edge.ends));
  }
  sort_once(lost);
  return lost;
}

}  // namespace burnish

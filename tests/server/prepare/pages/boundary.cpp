#include "tests/server/prepare/pages/boundary.h"

#include <algorithm>

namespace burnish {

void Boundary::add(Edge edge, const Passes& passes) {
  const auto found = edges_.try_emplace(edge).first;
  found->second.sum += passes.sum;
  found->second.is_odd ^= passes.is_odd;
  if (found->second.is_none()) edges_.erase(found);
}

void Boundary::add_triangle(const std::array<uint32_t, 3>& places) {
  for (int corner = 0; corner < 3; ++corner) {
    const uint64_t from = places[corner], to = places[(corner + 1) % 3];
    if (from == to) continue;
    add(std::min(from, to) << 32 | std::max(from, to), {from < to ? 1 : -1, true});
  }
}

void Boundary::add(const Boundary& other) {
  for (const auto& [edge, passes] : other.edges_) add(edge, passes);
}

Boundary::Passes Boundary::at(Edge edge) const {
  const auto found = edges_.find(edge);
  return found == edges_.end() ? Passes{} : found->second;
}

}  // namespace burnish

#include "server/prepare/sheets/triangle_finder.h"

#include <algorithm>
#include <utility>

#include "common/mesh/statistics/statistics.h"
#include "server/prepare/pages/page_vertices.h"
#include "server/prepare/radix_sort.h"

namespace burnish {

namespace {

bool is_lower(const Vec3i& a, const Vec3i& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Returns the corner with the least place.
int first_corner(const std::array<Vec3i, 3>& places) {
  return static_cast<int>(std::ranges::min_element(places, is_lower) - places.begin());
}

/// Returns the same hash whichever corner comes first.
uint64_t hash_of(const std::array<Vec3i, 3>& places) {
  const int first = first_corner(places);
  uint64_t hash = 0;
  for (int k = 0; k < 3; ++k)
    for (const int step : places[(first + k) % 3]) {
      hash = (hash ^ static_cast<uint32_t>(step)) * 0xd6e8feb86659fd93;
      hash ^= hash >> 32;
    }
  return hash;
}

/// Returns the turn that takes `from` to `to`, if there is one.
std::optional<int> turn_between(const std::array<Vec3i, 3>& from, const std::array<Vec3i, 3>& to) {
  for (int turn = 0; turn < 3; ++turn)
    if (from[0] == to[turn] && from[1] == to[(turn + 1) % 3] && from[2] == to[(turn + 2) % 3])
      return turn;
  return std::nullopt;
}

}  // namespace

TriangleFinder::TriangleFinder(const MeshView& mesh, const PageGrid& grid,
                               const ScratchSpace& space, const LoopPart& part)
    : triangles_(mesh.triangles), sorted_(space, mesh.triangles.size()) {
  const MeshStatistics unread;
  GridPlaces placed = place_on_grid({mesh.vertices, mesh.triangles, {}, unread}, grid, space, part);
  places_ = std::move(placed.positions);
  raise_places({placed.below.data(), placed.below.size()}, part);
  parallel_for_heard(part, triangles_.size(), [&](size_t t) {
    const auto triangle = static_cast<uint32_t>(t);
    sorted_[t] = {hash_of(places_of(triangle)), triangle};
  });
  ScratchArray<Entry> spare(space, sorted_.size());
  radix_sort(
      std::span(sorted_.data(), sorted_.size()), std::span(spare.data(), spare.size()),
      [](const Entry& entry) { return entry.hash; }, part);
}

void TriangleFinder::raise_places(std::span<const uint8_t> below, const LoopPart& part) {
  for_each_heard(part, below.size(), [&](size_t v) {
    if (below[v] == 0) return;
    const Vec3i place = places_[v];
    for (int axis = 0; axis < 3; ++axis) places_[v][axis] += below[v] >> axis & 1;
    raised_.push_back({place, places_[v]});
  });
  const auto is_before = [](const Raised& a, const Raised& b) {
    return a.below != b.below ? is_lower(a.below, b.below) : is_lower(a.above, b.above);
  };
  sort_heard(part, raised_.begin(), raised_.end(), is_before);
  const auto rest = std::ranges::unique(raised_, [](const Raised& a, const Raised& b) {
    return a.below == b.below && a.above == b.above;
  });
  raised_.erase(rest.begin(), rest.end());
}

std::span<const TriangleFinder::Raised> TriangleFinder::raised(const Vec3i& place) const {
  const auto found = std::ranges::equal_range(raised_, place, is_lower, &Raised::below);
  return {found.begin(), found.end()};
}

std::array<Vec3i, 3> TriangleFinder::places_of(uint32_t triangle) const {
  const Triangle& corners = triangles_[triangle];
  return {places_[corners[0]], places_[corners[1]], places_[corners[2]]};
}

// A place below a plane is also that of vertices which lie there.
std::optional<FoundTriangle> TriangleFinder::find(const std::array<Vec3i, 3>& places) const {
  std::array<std::vector<Vec3i>, 3> choices;
  for (int k = 0; k < 3; ++k) {
    choices[k].push_back(places[k]);
    for (const Raised& known : raised(places[k])) choices[k].push_back(known.above);
  }
  for (const Vec3i& a : choices[0])
    for (const Vec3i& b : choices[1])
      for (const Vec3i& c : choices[2])
        if (const auto found = find_raised({a, b, c})) return found;
  return std::nullopt;
}

std::optional<FoundTriangle> TriangleFinder::find_raised(const std::array<Vec3i, 3>& places) const {
  const uint64_t hash = hash_of(places);
  const auto* entry = std::lower_bound(sorted_.begin(), sorted_.end(), hash,
                                       [](const Entry& e, uint64_t h) { return e.hash < h; });
  for (; entry != sorted_.end() && entry->hash == hash; ++entry)
    if (const auto turn = turn_between(places, places_of(entry->triangle)))
      return FoundTriangle{entry->triangle, *turn};
  return std::nullopt;
}

}  // namespace burnish

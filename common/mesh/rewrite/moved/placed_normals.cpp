#include "common/mesh/rewrite/moved/placed_normals.h"

#include <algorithm>
#include <utility>

#include "common/mesh/reading/vertex_welder.h"

namespace burnish {

namespace {

/// A normal and its place.
struct Placed {
  uint32_t place = kNoPlace;
  uint32_t normal = 0;
  auto operator<=>(const Placed&) const = default;
};

/// A direction at a place, and the triangles around it.
struct Direction {
  Vec3d normal;  // of length 1
  AreaVectors area;
};

/// Returns the normals that do not have their place alone, by place.
std::vector<Placed> shared_places(std::span<const uint32_t> places) {
  size_t count = 0;
  for (const uint32_t place : places)
    if (place != kNoPlace) count = std::max(count, place + size_t{1});
  std::vector<bool> is_taken(count, false), is_shared(count, false);
  for (const uint32_t place : places) {
    if (place == kNoPlace) continue;
    if (is_taken[place]) is_shared[place] = true;
    is_taken[place] = true;
  }
  std::vector<Placed> placed;
  for (uint32_t n = 0; n < places.size(); ++n)
    if (places[n] != kNoPlace && is_shared[places[n]]) placed.push_back({places[n], n});
  std::ranges::sort(placed);
  return placed;
}

/// Gathers the directions of one place.
class PlaceDirections {
 public:
  /// Returns the number of the direction that a normal belongs to. A hostile file has many at one
  /// place; those beyond the limit stay alone.
  size_t find(const Vec3d& normal) {
    constexpr size_t kDirectionsMax = 16;
    constexpr double kSameCosine = 1 - 1e-5;
    for (size_t d = 0; d < std::min(kDirectionsMax, directions_.size()); ++d)
      if (directions_[d].normal.dot(normal) > kSameCosine) return d;
    directions_.push_back({normal, {}});
    return directions_.size() - 1;
  }

  void share(std::span<const Placed> placed, std::span<const Vec3f> normals,
             std::span<AreaVectors> areas) {
    directions_.clear();
    direction_of_.clear();
    for (const Placed& one : placed) {
      const Vec3d normal = normals[one.normal].cast<double>();
      direction_of_.push_back(
          find(normal.allFinite() ? Vec3d(normal.stableNormalized()) : Vec3d(Vec3d::Zero())));
      AreaVectors& area = directions_[direction_of_.back()].area;
      area.before += areas[one.normal].before;
      area.after += areas[one.normal].after;
    }
    for (size_t i = 0; i < placed.size(); ++i)
      areas[placed[i].normal] = directions_[direction_of_[i]].area;
  }

 private:
  std::vector<Direction> directions_;
  std::vector<size_t> direction_of_;
};

}  // namespace

Places find_places(std::span<const Vec3d> positions) {
  Places places;
  places.of_vertex.reserve(positions.size());
  std::vector<Vec3d> distinct;
  VertexWelder welder(distinct);
  for (const Vec3d& position : positions) places.of_vertex.push_back(welder.index_of(position));
  places.count = static_cast<uint32_t>(distinct.size());
  return places;
}

void share_areas(std::span<const uint32_t> places, std::span<const Vec3f> normals,
                 std::span<AreaVectors> areas) {
  const std::vector<Placed> placed = shared_places(places);
  PlaceDirections directions;
  for (size_t begin = 0; begin < placed.size();) {
    size_t end = begin;
    while (end < placed.size() && placed[end].place == placed[begin].place) ++end;
    directions.share(std::span(placed).subspan(begin, end - begin), normals, areas);
    begin = end;
  }
}

}  // namespace burnish

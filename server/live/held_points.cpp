#include "server/live/held_points.h"

#include <algorithm>
#include <utility>

namespace burnish {

namespace {

// A vertex on a plane of the lattice is in the step on either side (place_vertices() of
// server/prepare/pages). Rounding moves it over the plane by less.
constexpr double kOnPlane = 1e-3;  // steps

bool is_before(const Vec3i& a, const Vec3i& b) {
  return std::ranges::lexicographical_compare(a, b);
}

void add_places(const Vec3d& point, const PageGrid& lattice, std::vector<Vec3i>& places) {
  const Vec3d margin = Vec3d::Constant(kOnPlane * lattice.step());
  const Vec3i low = lattice.quantise(point - margin), high = lattice.quantise(point + margin);
  for (int x = low.x(); x <= high.x(); ++x)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int z = low.z(); z <= high.z(); ++z) places.emplace_back(x, y, z);
}

}  // namespace

HeldPoints::HeldPoints(const PreparedMesh& prepared, std::shared_ptr<const HeldRims> rims)
    : rims_(std::move(rims)) {
  for (const uint32_t vertex : rims_->places) points_.push_back(prepared.vertices[vertex]);
}

HeldVertices HeldPoints::of(const std::shared_ptr<const LivePage>& page) {
  if (page->edge_vertices.empty()) return nullptr;
  if (places_.empty() || page->lattice != lattice_) place_on(page->lattice);
  const auto known = found_.find(page.get());
  if (known != found_.end() && !known->second.page.expired()) return known->second.held;
  std::erase_if(found_, [](const auto& entry) { return entry.second.page.expired(); });
  return found_.insert_or_assign(page.get(), Found{page, find(*page)}).first->second.held;
}

void HeldPoints::place_on(const PageGrid& lattice) {
  lattice_ = lattice;
  found_.clear();
  places_.clear();
  for (const Vec3d& point : points_) add_places(point, lattice, places_);
  std::ranges::sort(places_, is_before);
}

HeldVertices HeldPoints::find(const LivePage& page) const {
  std::shared_ptr<std::vector<uint8_t>> held;
  for (const auto& [position, vertex] : page.edge_vertices) {
    if (!std::ranges::binary_search(places_, position, is_before)) continue;
    if (!held) held = std::make_shared<std::vector<uint8_t>>(held_bytes(page.size.vertices));
    (*held)[vertex / 8] |= static_cast<uint8_t>(1U << vertex % 8);
  }
  return held;
}

}  // namespace burnish

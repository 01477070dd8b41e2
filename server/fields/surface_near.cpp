#include "server/fields/surface_near.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/grid/morton.h"
#include "common/grid/stencil_slots.h"
#include "server/prepare/passages.h"

namespace burnish {

static constexpr float kRingsPerCell = 2;  // with wide rings more nodes lead on twice

SurfaceNear::SurfaceNear(const PreparedMesh& prepared, std::vector<int64_t> cells)
    : prepared_(prepared), cells_(std::move(cells)), seen_(cells_.size()) {
  add_nodes();
}

void SurfaceNear::add_nodes() {
  const std::span<const CellSheet> sheets = prepared_.sheets;
  const int64_t first = cells_.empty() ? 0 : cells_.front();
  auto next = std::ranges::lower_bound(sheets, first, {}, &CellSheet::cell);
  for (size_t i = 0; i < cells_.size(); ++i) {
    keys_.push_back(prepared_.cells[cells_[i]]);
    const Vec3i cell = morton_point(keys_.back());
    const auto index = static_cast<int32_t>(i);
    first_node_.push_back(static_cast<int32_t>(nodes_.size()));
    while (next != sheets.end() && next->cell < cells_[i]) ++next;
    if (next == sheets.end() || next->cell != cells_[i]) nodes_.push_back({index, kNone, cell});
    for (; next != sheets.end() && next->cell == cells_[i]; ++next)
      nodes_.push_back({index, static_cast<int32_t>(next - sheets.begin()), cell});
  }
  first_node_.push_back(static_cast<int32_t>(nodes_.size()));
}

/// Searches from `begin` on, in longer and longer steps: most neighbours are near in the order.
static std::span<const MortonKey> stretch_with(std::span<const MortonKey> keys, MortonKey key,
                                               size_t begin) {
  size_t first = begin, last = begin;
  for (size_t step = 1; last < keys.size() && keys[last] < key; step *= 2) {
    first = last + 1;
    last += step;
  }
  for (size_t step = 1; first > 0 && keys[first - 1] >= key; step *= 2) {
    last = first - 1;
    first -= std::min(first, step);
  }
  return keys.subspan(first, std::min(last + 1, keys.size()) - first);
}

int64_t SurfaceNear::index_of(const Vec3i& cell, size_t begin) const {
  const int side = prepared_.frame.cells_per_side();
  if ((cell.array() < 0).any() || (cell.array() >= side).any()) return kNone;
  const MortonKey key = morton_key(cell);
  const auto stretch = stretch_with(keys_, key, begin);
  const auto found = std::ranges::lower_bound(stretch, key);
  return found != stretch.end() && *found == key ? &*found - keys_.data() : kNone;
}

uint32_t SurfaceNear::passages_of(const Node& node) const {
  return node.sheet == kNone ? prepared_.passages[cells_[node.index]]
                             : prepared_.sheets[node.sheet].passages;
}

bool SurfaceNear::hang_together(const Node& node, const Node& other, int slot) const {
  if ((passages_of(other) >> opposite_slot(slot) & 1) == 0) return false;
  if (node.sheet == kNone || other.sheet == kNone) return true;
  return prepared_.sheets[node.sheet].component == prepared_.sheets[other.sheet].component;
}

// The integrals of the corners' functions have the integral of the place in them.
Vec3f SurfaceNear::centre_of(const Node& node) const {
  const CellIntegrals& integrals = node.sheet == kNone ? prepared_.integrals[cells_[node.index]]
                                                       : prepared_.sheet_integrals[node.sheet];
  Vec3d sum = Vec3d::Zero();
  double area = 0;
  for (int corner = 0; corner < kCornersPerCell; ++corner) {
    const double part = integrals.mass_row_sum[corner];
    sum += part * Vec3d(corner & 1, corner >> 1 & 1, corner >> 2);
    area += part;
  }
  const Vec3d inside = area > 0 ? Vec3d(sum / area) : Vec3d::Constant(0.5);
  return (node.cell.cast<double>() + inside).cast<float>();
}

// Most nodes near a stroke are met by several dabs.
void SurfaceNear::find_neighbours(Node& node) {
  if (node.first != kNone) return;
  node.first = static_cast<int32_t>(neighbours_.size());
  const uint32_t passages = passages_of(node);
  for (int slot = 0; slot < kSlots; ++slot) {
    if ((passages >> slot & 1) == 0) continue;
    const int64_t index = index_of(node.cell + offset_of_slot(slot), node.index);
    if (index == kNone) continue;
    for (int32_t n = first_node_[index]; n < first_node_[index + 1]; ++n)
      if (hang_together(node, nodes_[n], slot)) neighbours_.push_back(n);
  }
  node.last = static_cast<int32_t>(neighbours_.size());
}

/// Returns how far the dab's centre is from a cell, 0 inside of it. Units: grid units.
double SurfaceNear::box_distance(const Vec3i& cell) const {
  const Vec3d low = cell.cast<double>();
  return (grid_centre_.cwiseMax(low).cwiseMin(low + Vec3d::Ones()) - grid_centre_).norm();
}

int64_t SurfaceNear::touched_cell() const {
  const Vec3d place = snap_to_planes(grid_centre_);
  if ((place.array() >= 0).all() && (place.array() < prepared_.frame.cells_per_side()).all()) {
    const int64_t own = index_of(place.array().floor().cast<int>(), 0);
    if (own != kNone) return own;
  }
  int64_t nearest = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (const Node& node : nodes_) {
    const double box = box_distance(node.cell);
    if (box >= radius_ || box >= least) continue;
    const double distance = (centre_of(node).cast<double>() - grid_centre_).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = node.index;
  }
  return nearest;
}

void SurfaceNear::begin(const Vec3d& centre, double radius) {
  for (const int32_t number : met_) nodes_[number].way = nodes_[number].led_on = kFar;
  met_.clear();
  for (std::vector<int32_t>& ring : rings_) ring.clear();
  centre_ = centre;
  grid_centre_ = prepared_.frame.to_grid(centre);
  radius_ = radius / prepared_.frame.cell_size;
  ring_ = 0;
  ++dab_;
  const int64_t index = touched_cell();
  if (index == kNone) return;
  for (int32_t n = first_node_[index]; n < first_node_[index + 1]; ++n) lead_to(n, nullptr);
}

/// Notes a way to a node, if it is the shortest so far. Null: the dab begins there.
void SurfaceNear::lead_to(int32_t number, const Node* from) {
  Node& node = nodes_[number];
  if (node.way == kFar && box_distance(node.cell) >= radius_) return;
  if (node.centre.x() == kFar) node.centre = centre_of(node);
  const float way = from ? from->way + (node.centre - from->centre).norm() : 0;
  if (way >= node.way || way >= kDetour * radius_ + kSlackCells) return;
  if (node.way == kFar) met_.push_back(number);
  node.way = way;
  const auto ring = static_cast<size_t>(way * kRingsPerCell);
  if (ring >= rings_.size()) rings_.resize(ring + 1);
  rings_[ring].push_back(number);
}

void SurfaceNear::lead_on(int32_t number) {
  Node& node = nodes_[number];
  if (node.led_on == node.way) return;
  node.led_on = node.way;
  find_neighbours(node);
  for (int32_t i = node.first; i < node.last; ++i) lead_to(neighbours_[i], &node);
}

double SurfaceNear::distance_of(size_t index) const {
  float way = kFar;
  for (int32_t n = first_node_[index]; n < first_node_[index + 1]; ++n)
    way = std::min(way, nodes_[n].way);
  const Vec3i& cell = nodes_[first_node_[index]].cell;
  const Vec3d middle = prepared_.frame.to_file(cell.cast<double>() + Vec3d::Constant(0.5));
  const double around = (way - kSlackCells) / kDetour * prepared_.frame.cell_size;
  return std::max((middle - centre_).norm(), around);
}

// A ring grows while its nodes lead on. Their ways are the shortest only when all have done so.
std::span<const SurfaceNear::Reached> SurfaceNear::next_ring() {
  reached_.clear();
  for (; ring_ < rings_.size() && reached_.empty(); ++ring_) {
    for (size_t i = 0; i < rings_[ring_].size(); ++i) lead_on(rings_[ring_][i]);
    for (const int32_t number : rings_[ring_]) {
      const auto index = static_cast<size_t>(nodes_[number].index);
      if (std::exchange(seen_[index], dab_) != dab_)
        reached_.push_back({index, distance_of(index)});
    }
  }
  return reached_;
}

}  // namespace burnish
